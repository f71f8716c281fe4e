#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

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

}  // namespace
}  // namespace plumb::crowd_test
