#include "reports/judge/neighbours.h"

#include <gtest/gtest.h>

#include "invariants/forged_runs.h"

namespace plumb::neighbours_test {
namespace {

constexpr double dt = 0.01;
const Stepping with_skin{.dt = dt, .h = dt, .skin = 0.001};

bool near_ground(double height, double falls, double gravity = 0, double spin = 0) {
  const Scene scene = box_on_ground(0.5, {0, -gravity});
  std::vector<BodyState> then = box_at({0, 0.5 + height}, {0, -falls});
  then[1].angular_velocity = spin;
  const Trace trace = forged(dt, {{then}, {box_at({0, 0.5 + height})}});
  return !Neighbours(scene, trace, with_skin).in_step(1).empty();
}

TEST(Neighbours, MayTouchWithinTheDistanceOfAStep) {
  EXPECT_TRUE(near_ground(0.00099, 0));
  EXPECT_FALSE(near_ground(0.00101, 0));
  EXPECT_TRUE(near_ground(0.0209, 2));
  EXPECT_FALSE(near_ground(0.0211, 2));
}

TEST(Neighbours, MayFallAndTurnTogether) {
  EXPECT_TRUE(near_ground(0.0019, 0, 10));
  EXPECT_FALSE(near_ground(0.0021, 0, 10));
  // Its corners are sqrt(1/2) m from the centre.
  EXPECT_TRUE(near_ground(0.0080, 0, 0, 1));
  EXPECT_FALSE(near_ground(0.0082, 0, 0, 1));
}

// A disc that comes at 2 m/s throws one at rest against the ground .03 m below and is hit again: before and after, both
// are slow.
TEST(Neighbours, MayBeThrownFromOneToTheNext) {
  Scene scene = box_on_ground();
  scene.bodies.push_back(scene.bodies[1]);
  scene.bodies[2].name = "above";
  const auto found = [&](double speed) {
    std::vector<BodyState> then = box_at({0, 0.53}, {});
    then.push_back({{0, 1.531}, 0, {0, -speed}, 0});
    std::vector<BodyState> now = then;
    now[2].velocity = {0, speed};
    const Trace trace = forged(dt, {{then}, {now}});
    return Neighbours(scene, trace, with_skin).in_step(1).size();
  };
  EXPECT_EQ(found(2), 2u);
  EXPECT_EQ(found(1), 1u);
}

// What is braked up to half a step early, at 2 m/s, may touch what is 1 cm farther away.
TEST(Neighbours, MayBeBrakedEarlyByTheStatedLead) {
  const Scene scene = box_on_ground();
  Stepping early = with_skin;
  early.impact_lead = 0.5;
  const auto found = [&](double height, const Stepping& stated) {
    const Trace trace = forged(dt, {{box_at({0, 0.5 + height}, {0, -2})}, {box_at({0, 0.5 + height - 0.02})}});
    return !Neighbours(scene, trace, stated).in_step(1).empty();
  };
  EXPECT_FALSE(found(0.0309, with_skin));
  EXPECT_TRUE(found(0.0309, early));
  EXPECT_FALSE(found(0.0311, early));
}

TEST(Neighbours, CountsWhatABodyDidMove) {
  const Trace jump = forged(dt, {{box_at({0, 0.6})}, {box_at({0, 0.5})}});
  EXPECT_FALSE(Neighbours(box_on_ground(), jump, with_skin).in_step(1).empty());
}

}  // namespace
}  // namespace plumb::neighbours_test
