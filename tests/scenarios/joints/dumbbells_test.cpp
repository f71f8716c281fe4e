#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::dumbbells_test {
namespace {

using statement_of::Of;

double expected(const std::string& body, Quantity quantity) {
  return *Of{"dumbbells", {}, body, quantity}.expectations().front().expected;
}

// Two points on a stiff spring instead of a rod: W^2 r/k of it too long.
TEST(Dumbbells, AgreeWithAnIntegrationOfTwoPointsOnAStiffSpring) {
  const Scenario& family = *Catalog<Scenario>::find("dumbbells");
  const Scene scene = family.scene(complete(family, {}));
  constexpr double stiffness = 1e6;                       // per mass
  const auto rate = [](const std::array<double, 8>& y) {  // x, y, vx, vy of both
    const double dx = y[4] - y[0];
    const double dy = y[5] - y[1];
    const double length = std::hypot(dx, dy);
    const double pull = stiffness * (length - 1.6) / length;
    return std::array<double, 8>{y[2], y[3], pull * dx, pull * dy - 10, y[6], y[7], -pull * dx, -pull * dy - 10};
  };
  const Body& a = scene.bodies[0];
  const Body& b = scene.bodies[1];
  const auto end = integrated(std::array<double, 8>{a.position.x, a.position.y, a.velocity.x, a.velocity.y,
                                                    b.position.x, b.position.y, b.velocity.x, b.velocity.y},
                              1.5, 20000, rate);
  EXPECT_NEAR(expected("first on rod", Quantity::x), end[0], 1e-4);
  EXPECT_NEAR(expected("first on rod", Quantity::y), end[1], 1e-4);
  EXPECT_NEAR(expected("first on weld", Quantity::x), end[0], 1e-4);
  EXPECT_NEAR(expected("first on weld", Quantity::y) - 4, end[1], 1e-4);
  EXPECT_NEAR(expected("one body", Quantity::x), (end[0] + end[4]) / 2, 1e-9);
  EXPECT_NEAR(expected("one body", Quantity::y) - 8, (end[1] + end[5]) / 2, 1e-9);
}

// Loose, the first disc would fly on along its tangent: two metres away.
TEST(Dumbbells, StopDiscsThatNothingHolds) {
  EXPECT_LT((Of{"dumbbells", {}, "first on rod", Quantity::x}.allows_at_most()), 1);
  EXPECT_LT((Of{"dumbbells", {}, "first on weld", Quantity::y}.allows_at_most()), 1);
}

}  // namespace
}  // namespace plumb::dumbbells_test
