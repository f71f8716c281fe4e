#pragma once

#include <span>
#include <vector>

#include "body_set.h"
#include "contact.h"
#include "impulse/world.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Tells which parts began and ceased to touch from one step to the next.
class TouchLog {
 public:
  /// Takes down a step that has been solved. The contacts are sorted.
  void note(const BodySet& bodies, std::span<const Contact> contacts);
  ContactEvents events() const { return {begun_, touching_, ended_}; }

 private:
  std::vector<TouchingParts> begun_, touching_, ended_;
  std::vector<TouchingParts> last_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
