#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "contacts/contact_rows.h"
#include "narrow_phase/collide.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bounds of the relative motion of a contact's bodies. Rotation of a disc about its centre does not count.
struct Stir {
  Real speed = 0;    // m/s, of their surfaces
  Real turning = 0;  // rad/s, rotation that may carry the normal and arms along

  /// Whether penetration may grow within a step by more than a load at rest may cause.
  bool moves(Real dt) const { return speed * dt > tolerated_sink; }
};
Stir stir_of(const Contact& contact, const BodySet& bodies);
/// Whether, with normal and arms constant for a step, the surfaces would approach faster than a soft contact recovers.
bool turns(const Contact& contact, const Stir& stir, const BodySet& bodies, Real dt);

/// The rows of an island whose bodies rotate so fast that normal and arms must be updated in every sub-step (rotating
/// contact frame).
///
/// Otherwise a row's normal and arms are constant in a step. But if the reference face rotates by a while the other
/// body slides along it by u, the surfaces approach by a u more than the row accounts for, and by w^2 r dt^2/2 because
/// arms rotate. At 5 rad/s and 60 Hz that is a millimetre in each step, faster than a soft contact recovers.
class Turning {
 public:
  /// Chooses the rows of an island for a step: all after an impact, which may set any body rotating.
  void begin(const Island& island, const StepData& data);

  /// Mid-step re-collision: finds contacts again whose bodies have slid past each other since the last time, because
  /// other corners may be near.
  void find_again(StepData& data, const std::vector<Pose>& start, const std::vector<Motion>& motion);

  /// The motions of two bodies since the start of the step.
  struct Pair {
    Motion a, b;
  };
  /// Finds the contact of one row again where its bodies will be within the sub-step, before they collide there, unless
  /// they are about where it was found last. Returns whether it did.
  bool find_at(StepData& data, const Island& island, const std::vector<Pose>& start, const std::vector<Motion>& motion,
               const ImpactRow& row, const Pair& then);

  /// Whether the number of points of a contact has changed since the last call.
  bool counts_changed() { return std::exchange(counts_changed_, false); }

  /// Updates normals and separations to the current motion, with arms relative to the start of the step.
  void follow(const Island& island, const std::vector<Motion>& motion);
  /// Updates normals and arms to the middle of the sub-step, and separations to the current motion.
  void lead(const Island& island, const BodySet& bodies, const std::vector<Motion>& motion);

 private:
  /// A row as it was when its contact was found.
  struct Turned {
    ImpactRow* row;
    NormalOf normal_of;
    Vec2 normal;
    Real radius_a, radius_b;
    std::array<PointArms, 2> points;
    bool may_join = false;  // with another contact of one body on the ground
    bool again = false;     // it was found again within the step,
    Pair found;             // when its bodies had moved by this

    /// The motions since then.
    Pair since(const Pair& now) const;
  };
  void take_points(Turned& turned, Contact& contact, const Manifold& found);
  static void lose_points(ImpactRow& row);
  static bool is_far(const Turned& turned, const Pair& now, const BodySet& bodies);
  void find(StepData& data, Turned& turned, const Pair& now, const std::vector<Pose>& start);
  static Real way(const Turned& turned, const Pair& now, const BodySet& bodies);
  static Vec2 between(const Turned& turned, const PointArms& p, const Pair& by);
  static Vec2 direction(const Turned& turned, const Pair& by);
  static void turn(const Island& island, const Turned& turned, const Pair& now, const Pair& then, bool from_start);

  std::vector<Turned> turned_;  // in the order of the island's rows
  FlownMotions ahead_;
  bool counts_changed_ = false;
};

}  // namespace impulse::inline IMPULSE_PRECISION
