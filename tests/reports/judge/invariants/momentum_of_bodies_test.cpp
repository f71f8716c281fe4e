#include <gtest/gtest.h>

#include "holding.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

TEST(BodyMomentumInvariant, HoldsBodiesToTheImpulsesShown) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto moved = [&](double vy) {
    return forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, vy}), {pushing(1.1, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, moved(0), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, moved(2e-14), exact), CheckStatus::held);
  const auto broken = checked("momentum_of_bodies", scene, moved(1e-12), exact).value();
  EXPECT_EQ(broken.status, CheckStatus::broken);
  EXPECT_EQ(broken.where, "box");
}

// Two discs of 1 m, one upon the other, and a push straight up of 2 N s: where the upper one is carried 1 mm to the
// side within the step, their normal turns by 1/2000 and gives it 1 mm/s kg to the side, although all is still at both
// ends.
TEST(BodyMomentumInvariant, KnowsThatRoundBodiesMayPassEachOtherWithinAStep) {
  Scene scene = box_on_ground(0.5, {0, -200});
  for (Body& body : scene.bodies) body.shapes[0].geometry = Circle{.radius = 1};
  const double mass = mass_of(scene.bodies[1]).mass;
  const auto carried = [&](double way, double vx) {
    return forged(dt, {{box_at({0, 2})}, {box_at({way, 2}, {vx, 0}), {pushing(2 * mass, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, carried(1e-3, 0.9e-3), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, carried(1e-3, 1.1e-3), exact), CheckStatus::broken);
  EXPECT_EQ(status("momentum_of_bodies", scene, carried(0, 1e-5), exact), CheckStatus::broken);
}

TEST(BodyMomentumInvariant, LetsSleepStopABodyThatIsSlowerThanStated) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  Stepping sleeping = exact;
  sleeping.rest_speed = 0.01;
  const auto stopped = [&](double before, double after) {
    return forged(dt, {{box_at({0, 0.5}, {before, 0})}, {box_at({0, 0.5}, {after, 0}), {pushing(0.1, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.009, 0), sleeping), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.009, 0), exact), CheckStatus::broken);
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.021, 0), sleeping), CheckStatus::broken);
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.009, 0.001), sleeping), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb
