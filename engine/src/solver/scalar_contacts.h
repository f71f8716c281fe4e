#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Makes the row of a contact for this step, or updates it if the contact kept its points. `start`: the pose of each
/// body at the start of the step.
void renew(ImpactRow& row, const BodySet& bodies, const std::vector<Pose>& start, const std::vector<Contact>& contacts,
           std::uint32_t index);

/// Writes the results of the step from a row back to its contact. `offset_scale`: see Island.
void write_back(ImpactRow& row, Real offset_scale, std::vector<Contact>& contacts);

/// The contacts of an island in the stages of a sub-step of `accurate`, solved one after another. `motion` is of each
/// body since the start of the step.
class ScalarContacts {
 public:
  ScalarContacts(BodySet& bodies, const std::vector<Motion>& motion) : bodies_(bodies), motion_(motion) {}

  /// The data of two points solved together that stay constant in a step.
  static PointPair pair_of(const Island& island, const ImpactRow& row);
  /// Splits the impulses of the last sub-step in halves, one for each kick: `kicks` gets the velocity change of each
  /// body for one half. Both act along the normal at the start of the sub-step.
  void halve(const Island& island, std::vector<Velocity>& kicks) const;
  /// Adds the halves to the accumulated impulses, after each kick.
  void count_halves(const Island& island);
  /// Sets the gaps for the solves below, while bodies stay where they are.
  void measure(const Island& island) const;
  /// Leaves out of this sub-step what bears nothing and would not close if its bodies were thrown at each other twice
  /// as fast: most rows of a heap, whose bodies may be struck. Impacts::hold_those_that_meet() takes back what meets.
  void leave_out_far(const Island& island) const;
  /// Solves contacts as soft constraints; a gap may close within the sub-step, but no further. Friction is solved in
  /// relax(), except in a contact's first step (otherwise a box set down on a slope slips before it is held).
  void press(const Island& island);
  /// The same with rigid contacts, all or some of those that act: nothing gets deeper, and what overlaps is pushed
  /// apart at the same rate.
  void press_rigidly(const Island& island, std::span<const std::uint32_t> rows);
  /// Rigid contacts with friction, regardless of depth. Skips points with a gap and no load, which would be braked one
  /// sub-step before they arrive.
  void relax(const Island& island, std::span<const std::uint32_t> rows);
  /// At the start of a sub-step: a contact that bore nothing slips if its points move past each other faster than
  /// `slow`, m/s.
  void meet(const Island& island, Real slow) const;
  /// Decides after relax() which contacts slip: those that need all of the friction they have and move all the same, in
  /// a web faster than `slow_in_web`, m/s. Points share what a contact bears, so it slips only if none has any left.
  /// Returns whether one broke away, and friction must be solved again.
  bool stick_or_slip(const Island& island, Real slow_in_web) const;
  /// After relax(): what two discs bore before they drifted acts along the normal of then.
  void turn_back(const Island& island);
  /// Whether a contact penetrates deeper in a sub-step at these velocities by more than its share of `in_step`, m, of
  /// all sub-steps. `held`: without the points that relax() skips.
  bool deepens(const Island& island, Real in_step, bool held) const;
  bool deepens(const Island& island, const ImpactRow& row, Real in_step, bool held) const;
  void settle_offsets(const Island& island);

 private:
  /// Calls solve(row, frame) and writes the frame back to the velocities.
  template <class Solve>
  static void in_frame(ImpactRow& row, std::vector<Velocity>& velocity, Solve solve);
  /// The same for each of some rows.
  template <class Solve>
  void each_of(const Island& island, std::span<const std::uint32_t> rows, Solve solve);
  void face(ImpactRow& row) const;
  void turn_normal(ImpactRow& row);
  void push_centres(const ImpactRow& row, Vec2 impulse);
  template <bool rigidly, class Frame>
  static void press_row(const Island& island, ImpactRow& row, Frame& frame);
  template <class Frame>
  static void relax_row(ImpactRow& row, Frame& frame);
  template <bool rigidly, class Frame>
  static bool press_pair(const Island& island, ImpactRow& row, Frame& frame);
  template <class Frame>
  static bool relax_pair(ImpactRow& row, Frame& frame);

  BodySet& bodies_;
  const std::vector<Motion>& motion_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
