#pragma once

#include <cstdint>
#include <vector>

#include "bodies/body_set.h"
#include "solver/island.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What was pressed within a sub-step, but is pushed by nothing in the end, flies on without the rounding of what it
/// was given and gave back: no contact would explain it.
class Unpushed {
 public:
  /// Remembers how the island's bodies come out of a sub-step by the force field alone.
  void note(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration);
  /// Gives that to those that carry no load, by the marks of all bodies.
  void restore(const Island& island, const std::vector<std::uint8_t>& loaded, BodySet& bodies) const;

 private:
  std::vector<Velocity> flown_;  // of the island's bodies
};

}  // namespace impulse::inline IMPULSE_PRECISION
