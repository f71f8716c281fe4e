#pragma once

#include <vector>

#include "bodies/body_set.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Makes the row of a contact for this step; of a row whose contact kept its points only what is new of them. `start`:
/// where each body begins the step.
void renew(ImpactRow& row, const BodySet& bodies, const std::vector<Pose>& start, const std::vector<Contact>& contacts,
           std::uint32_t index);

/// Hands back to its contact what the step made of a row. `offset_scale`: see Island.
void leave(ImpactRow& row, Real offset_scale, std::vector<Contact>& contacts);

/// The contacts of an island through the stages of a sub-step of `accurate`, one after another. `motion` is of each
/// body since the start of the step.
class ScalarContacts {
 public:
  ScalarContacts(BodySet& bodies, const std::vector<Motion>& motion) : bodies_(bodies), motion_(motion) {}

  /// What stays through a step of two points that are solved at once.
  static PointPair pair_of(const Island& island, const ImpactRow& row);
  /// What the contacts bore in the last sub-step is given again, half in each kick: `kicks` is what a half does to the
  /// velocity of each body.
  static void halve(const Island& island, std::vector<Velocity>& kicks);
  /// After each kick.
  void count_halves(const Island& island);
  /// Contacts give way as damped springs; a gap that would close within the sub-step is closed just so far. Friction
  /// waits for the rigid pass, except in a contact's first step (else a box set down on a slope slips before it is
  /// held).
  void press(const Island& island);
  /// The same again, but rigid.
  void press_rigidly(const Island& island);
  /// Rigid contacts with friction, no memory of depth. What has a gap and no load is left alone: it would be braked one
  /// sub-step before it arrives.
  void relax(const Island& island);
  /// m, by how much the contact comes deeper that does so most in a sub-step at these velocities. `held`: not counting
  /// those that relax() leaves alone.
  Real deepening(const Island& island, bool held) const;
  void settle_offsets(const Island& island);

 private:
  /// Calls solve(row, frame); the velocities then learn what the frame was given.
  template <class Solve>
  static void in_frame(ImpactRow& row, std::vector<Velocity>& velocity, Solve solve);
  /// The same for each row that takes part.
  template <class Solve>
  void each(const Island& island, Solve solve);
  template <class Frame>
  Real gap(const ImpactRow& row, const RowPoint& p) const;
  void turn_normal(ImpactRow& row);
  template <bool rigidly>
  void press(const Island& island);
  template <bool rigidly, class Frame>
  bool press_pair(const Island& island, ImpactRow& row, Frame& frame) const;
  template <class Frame>
  bool relax_pair(ImpactRow& row, Frame& frame) const;

  BodySet& bodies_;
  const std::vector<Motion>& motion_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
