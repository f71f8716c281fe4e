#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::disturbed_test {
namespace {

using statement_of::Of;

Scene scene_of(const char* name, const Parameters& changes = {}) {
  const Scenario& family = *Catalog<Scenario>::find(name);
  return family.scene(complete(family, changes));
}

// Momentum and energy of striker and box decide both velocities; that the box stays still at first is one solution of
// the two equations, and that it leaves is the other.
TEST(LateBlow, KeepsMomentumAndEnergy) {
  for (const double speed : {1.5, 4.0, 20.0}) {
    const Parameters changes{{"speed", speed}};
    const Scene scene = scene_of("late-blow", changes);
    const double box = mass_of(scene.bodies[1]).mass;
    const double striker = mass_of(scene.bodies[2]).mass;
    const double v = *Of{"late-blow", changes, "box", Quantity::vx}.expectations().front().expected;
    const double left = *Of{"late-blow", changes, "striker", Quantity::vx}.expectations().front().expected;
    EXPECT_NEAR(box * v + striker * left, striker * speed, 1e-9);
    EXPECT_NEAR(box * v * v + striker * left * left, striker * speed * speed, 1e-9);
    EXPECT_GT(v, left);
  }
}

// The striker flies for two seconds, and the box for the last one.
TEST(LateBlow, HitsAfterTwoSeconds) {
  const Scene scene = scene_of("late-blow");
  const Body& striker = scene.bodies[2];
  const double way = -0.5 - 0.5 - striker.position.x;  // m, from its centre to where it touches the box
  EXPECT_NEAR(way / striker.velocity.x, 2, 1e-12);
  EXPECT_NEAR(*Of({"late-blow", {}, "box", Quantity::x}).expectations().back().expected, striker.velocity.x, 1e-12);
}

TEST(LateBlow, StopsABoxThatIsAsleep) {
  EXPECT_LT((Of{"late-blow", {}, "box", Quantity::vx}.allows_at_most()), 4.0 / 1000);
}

// The plank's edge leaves the disc's rim behind: at no time after the edge has passed the centre is it nearer than the
// radius, as the disc falls by g t^2/2 while the edge moves by V t.
TEST(LostSupport, LeavesTheDiscFreeAtOnce) {
  const Scene scene = scene_of("lost-support");
  const double radius = std::get<Circle>(scene.bodies[2].shapes[0].geometry).radius;
  const Expectation fallen = Of{"lost-support", {}, "disc", Quantity::vy}.expectations().front();
  const double fall = -*fallen.expected / 10;  // s
  for (double t = 1e-4; t < fall; t += 1e-4) EXPECT_GT(std::hypot(12 * t, radius - 5 * t * t), radius) << t;
  // Until then the edge has come the way from under the centre.
  const double edge = scene.bodies[1].position.x - 2;
  EXPECT_NEAR(2 + (scene.bodies[2].position.x - edge) / 12, scene.duration - fall, 1e-12);
}

// A disc that stays where it slept is 1.5 m/s and decimetres off.
TEST(LostSupport, StopsADiscThatIsAsleep) {
  const Expectation last = Of{"lost-support", {}, "disc", Quantity::vy}.expectations().back();
  for (const Stepping& stated : statement_of::all()) EXPECT_LT(last.allowed(stated), -*last.expected / 4);
}

}  // namespace
}  // namespace plumb::disturbed_test
