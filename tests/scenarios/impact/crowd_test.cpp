#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::crowd_test {
namespace {

using statement_of::Of;

Scene scene_of(const Parameters& changes) {
  const Scenario& family = *Catalog<Scenario>::find("crowd");
  return family.scene(complete(family, changes));
}

// The left disc flies until it touches the right one; by momentum and energy equal masses then swap velocities.
TEST(Crowd, MovesAsEachPairAlone) {
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"every", 16}}, {{"pairs", 40}, {"every", 13}}}) {
    const Scene scene = scene_of(changes);
    std::size_t checked = 0;
    for (std::size_t i = 0; i + 1 < scene.bodies.size(); i += 2) {
      const Body& left = scene.bodies[i];
      const Body& right = scene.bodies[i + 1];
      if (left.velocity.x == 0) continue;
      const double radius = std::get<Circle>(left.shapes[0].geometry).radius;
      const double meet = (right.position.x - left.position.x - 2 * radius) / left.velocity.x;
      EXPECT_LT(meet, scene.duration);
      const auto read = [&](const std::string& body, Quantity quantity) {
        try {
          return *Of{"crowd", changes, body, quantity}.expectations().front().expected;
        } catch (const std::logic_error&) {
          return std::nan("");  // this pair is not read
        }
      };
      const double x = read(right.name, Quantity::x);
      if (std::isnan(x)) continue;
      ++checked;
      EXPECT_NEAR(x, right.position.x + left.velocity.x * (scene.duration - meet), 1e-12);
      EXPECT_NEAR(read(left.name, Quantity::x), right.position.x - 2 * radius, 1e-12);
      EXPECT_EQ(read(right.name, Quantity::vx), left.velocity.x);
    }
    EXPECT_GE(checked, 1u);
  }
}

// Each on a line of its own, wider than two radii.
TEST(Crowd, HasPairsThatNeverMeetOthers) {
  const Scene scene = scene_of({});
  for (std::size_t i = 2; i + 1 < scene.bodies.size(); i += 2)
    EXPECT_GT(scene.bodies[i].position.y - scene.bodies[i - 2].position.y, 0.8);
}

// One pair of 150 that misses, the slowest, changes energy and position by more than is allowed.
TEST(Crowd, StopsACrowdInWhichAPairMisses) {
  EXPECT_LT((Of{"crowd", {}, "right 1", Quantity::vx}.allows_at_most()), 1.5 / 1000);
  const double lost = 0.5 * 3.14 * 0.16 * 1.5 * 1.5 * 0.19;  // J, of an impact with e = .9
  EXPECT_LT((Of{"crowd", {}, "", Quantity::energy}.allows(statement_of::accurate())), lost);
}

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
}  // namespace plumb::crowd_test
