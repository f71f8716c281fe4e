#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "contacts/contact_rows.h"
#include "narrow_phase/manifolds.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How fast the bodies of a contact may pass each other. That a disc turns about its centre moves nothing of it.
struct Stir {
  Real speed = 0;    // m/s, of their surfaces
  Real turning = 0;  // rad/s, of what may turn their normal and arms with it

  /// Whether they may come deeper within a step than a load at rest may press them.
  bool moves(Real dt) const { return speed * dt > tolerated_sink; }
};
Stir stir_of(const Contact& contact, const BodySet& bodies);
/// Whether with a normal and arms that stand still for a step surfaces near each other faster than a soft contact
/// recovers.
bool turns(const Contact& contact, const Stir& stir, const BodySet& bodies, Real dt);

/// The shape whose face a contact's normal stands on, or the line between the nearest points of the two.
enum class NormalOf : std::uint8_t { between, a, b };

/// Rows of an island whose bodies turn so fast that normal and arms must follow them from sub-step to sub-step.
///
/// A row's normal stands still for a step, and so do its arms. But the face that it stands on turns, by a, while what
/// touches it slides along, by u: then the surfaces come by a u nearer to each other than the row sees, and by
/// w^2 r dt^2/2 because arms turn. At 5 rad/s and 60 Hz that is a millimetre in each step, faster than a soft contact
/// recovers.
class Turning {
 public:
  /// Chooses the rows of an island for a step: after a blow all, for it may set anything turning.
  void begin(const Island& island, const StepData& data);

  /// Where bodies have gone past each other since their contact was found, finds it again: other corners may be near,
  /// one more or one less.
  void find_again(StepData& data, const std::vector<Pose>& start, const std::vector<Motion>& motion);

  /// Whether a contact has one point more or less since this was asked last.
  bool counts_changed() { return std::exchange(counts_changed_, false); }

  /// Puts normals and separations where they are now, with the arms that lead there from the start of the step.
  void follow(const Island& island, const std::vector<Motion>& motion);
  /// Puts normals and arms where they will be in the middle of the sub-step, and the separations where they are now.
  void lead(const Island& island, const BodySet& bodies, const std::vector<Motion>& motion);

 private:
  struct Pair {
    Motion a, b;
  };
  /// As the row was when it was found.
  struct Turned {
    ImpactRow* row;
    NormalOf normal_of;
    Vec2 normal;
    Real radius_a, radius_b;
    std::array<PointArms, 2> points;
    bool again = false;  // it was found within the step:
    Pair found;          // how its bodies had moved then

    /// How they have moved since.
    Pair since(const Pair& now) const;
  };
  void take_points(Turned& turned, Contact& contact, const Manifold& found);
  static Real way(const Turned& turned, const Pair& now, const BodySet& bodies);
  static Vec2 between(const Turned& turned, const PointArms& p, const Pair& by);
  static Vec2 direction(const Turned& turned, const Pair& by);
  static void turn(const Island& island, const Turned& turned, const Pair& now, const Pair& then, bool from_start);

  std::vector<Turned> turned_;
  bool counts_changed_ = false;
};

}  // namespace impulse::inline IMPULSE_PRECISION
