#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
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

// The two as point masses on a stiff spring, which turns none of them, by the velocity Verlet method: the pull that
// keeps them apart is all it takes for the circles that the scene expects.
TEST(JoinedPair, CirclesAsTwoMassesOnAStiffSpringDo) {
  const Scenario& scenario = *Catalog<Scenario>::find("joined-pair");
  const Parameters p = complete(scenario, {{"joint", 1}});
  const Scene scene = scenario.scene(p);
  const double masses[] = {mass_of(scene.bodies[0]).mass, mass_of(scene.bodies[1]).mass};
  Vec at[] = {scene.bodies[0].position, scene.bodies[1].position};
  Vec velocity[] = {scene.bodies[0].velocity, scene.bodies[1].velocity};
  const double reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
  const double stiffness = 1e7 * reduced;
  const double length = 2 - reduced * 2 * p.at("turn") * p.at("turn") / stiffness;  // stretched to 2 m
  constexpr double h = 1e-5;
  const auto push = [&](double time) {
    const Vec apart{at[1].x - at[0].x, at[1].y - at[0].y};
    const double distance = std::hypot(apart.x, apart.y);
    const double impulse = time * stiffness * (distance - length) / distance;
    for (const int i : {0, 1}) {
      const double way = (i == 0 ? impulse : -impulse) / masses[i];
      velocity[i] = {velocity[i].x + way * apart.x, velocity[i].y + way * apart.y};
    }
  };
  for (int step = 0; step < static_cast<int>(std::lround(scene.duration / h)); ++step) {
    push(h / 2);
    for (const int i : {0, 1}) at[i] = {at[i].x + h * velocity[i].x, at[i].y + h * velocity[i].y};
    push(h / 2);
  }
  const auto all = scenario.expectations(p);
  EXPECT_NEAR(*all[0].expected, at[0].x, 1e-5);
  EXPECT_NEAR(*all[1].expected, at[0].y, 1e-5);
  EXPECT_NEAR(*all[3].expected, at[1].x, 1e-5);
  EXPECT_NEAR(*all[4].expected, at[1].y, 1e-5);
}

}  // namespace
}  // namespace plumb::dumbbells_test
