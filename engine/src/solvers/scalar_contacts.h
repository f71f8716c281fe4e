#pragma once

#include <vector>

#include "body_set.h"
#include "solvers/impacts.h"
#include "solvers/island.h"
#include "solvers/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The contacts of an island through the stages of a sub-step of `accurate`, one after another. `motion` is of each
/// body since the start of the step.
class ScalarContacts {
 public:
  ScalarContacts(BodySet& bodies, const std::vector<Motion>& motion) : bodies_(bodies), motion_(motion) {}

  /// What stays through a step of two points that are solved at once.
  static PointPair pair_of(const Island& island, const ImpactRow& row);
  /// What the contacts bore in the last sub-step is given again, half in each kick.
  static void halve(const Island& island);
  void kick(const Island& island);
  /// Contacts give way as damped springs; a gap that would close within the sub-step is closed just so far. Friction
  /// waits for the rigid pass, except in a contact's first step (else a box set down on a slope slips before it is
  /// held).
  void press(const Island& island);
  /// Rigid contacts with friction, no memory of depth. What has a gap and no load is left alone: it would be braked one
  /// sub-step before it arrives.
  void relax(const Island& island);
  void settle_offsets(const Island& island);

 private:
  Real gap(const ImpactRow& row, const RowPoint& p) const;
  void turn_normal(ImpactRow& row);
  bool solve_pair(const Island& island, ImpactRow& row, ContactFrame& frame, bool pressing) const;

  BodySet& bodies_;
  const std::vector<Motion>& motion_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
