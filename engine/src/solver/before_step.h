#pragma once

#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "solver/island.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// An island without joints as it was before a step that may have been too long: for bodies that a blow sets rotating,
/// or drives through others. Such a step is done again.
class BeforeStep {
 public:
  /// `acceleration` is of each body, by forces.
  void keep(const StepData& data, const Island& island, const std::vector<Velocity>& acceleration);
  void restore(StepData& data, const Island& island, std::vector<Velocity>& acceleration) const;

  /// Whether bodies overlap after it by more than loads may cause, and by more than before, by `felt`, m. `motion` is
  /// of each body, from `start`. Looks at the shapes, as other corners may be near than contacts know.
  bool drove_deep(const StepData& data, const std::vector<Pose>& start, const std::vector<Motion>& motion,
                  Real felt) const;

 private:
  struct Moved {
    Velocity velocity, acceleration;
  };
  std::vector<Moved> bodies_;      // of the island
  std::vector<Contact> contacts_;  // of its ties
};

}  // namespace impulse::inline IMPULSE_PRECISION
