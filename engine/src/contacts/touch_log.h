#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "impulse/world.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Tells which parts began and ceased to touch from one step to the next.
class TouchLog {
 public:
  /// Takes down a step that has been solved. The contacts are sorted, and of bodies that are awake.
  void note(const BodySet& bodies, std::span<const Contact> contacts);
  ContactEvents events() const { return {begun_, asleep_.empty() ? awake_ : all_, ended_}; }

 private:
  void follow_sleep(const BodySet& bodies);

  std::vector<TouchingParts> begun_, ended_;
  std::vector<TouchingParts> awake_;   // pairs that the last step found touching
  std::vector<TouchingParts> last_;    // the same of the step before
  std::vector<TouchingParts> asleep_;  // pairs with a body asleep, as they were when it fell asleep
  std::vector<TouchingParts> all_;     // both, where some sleep
  std::uint64_t sleep_changes_ = 0;    // of the bodies, when they were last looked at
};

}  // namespace impulse::inline IMPULSE_PRECISION
