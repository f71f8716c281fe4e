#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::limiting_friction_test {
namespace {

using statement_of::Of;

double expected(const Parameters& changes, Quantity quantity) {
  return *Of{"limiting-friction", changes, "box", quantity}.expectations().front().expected;
}

// Coulomb's law in steps of 0.1 ms: at rest friction balances up to its static limit, and once the box moves it brakes
// with the dynamic one.
TEST(LimitingFriction, AgreesWithAnIntegrationOfCoulombsLaw) {
  for (const double margin : {-0.05, -5e-5, 5e-5, 0.05}) {
    for (const double dynamic : {0.0, 0.3, 0.45}) {
      const Parameters changes{{"margin", margin}, {"dynamic", dynamic}};
      const Scenario& family = *Catalog<Scenario>::find("limiting-friction");
      const Scene scene = family.scene(complete(family, changes));
      const double pull = std::get<Constant>(scene.forces[0]).force.x / mass_of(scene.bodies[1]).mass;
      const Surface& rough = scene.bodies[1].shapes[0].surface;
      double x = 0;
      double v = 0;
      constexpr double h = 1e-4;
      for (int i = 0; i < 20000; ++i) {
        const bool sticks = v == 0 && pull <= rough.static_friction * 10;
        v += sticks ? 0 : h * (pull - rough.dynamic_friction * 10);
        x += h * v;
      }
      EXPECT_NEAR(expected(changes, Quantity::vx), v, 1e-9) << margin << ' ' << dynamic;
      EXPECT_NEAR(expected(changes, Quantity::x), x, 2e-3) << margin << ' ' << dynamic;
    }
  }
}

// Just beyond the limit the box is 6 m away at the end, just below it has not moved: a method that takes the wrong one
// of the two coefficients is stopped.
TEST(LimitingFriction, StopsTheWrongSideOfTheLimit) {
  const double breaks = expected({}, Quantity::x);
  EXPECT_NEAR(breaks, (0.6 * 10 * (1 + 5e-5) - 0.3 * 10) * 2, 1e-9);
  const Stepping stated = statement_of::accurate();
  EXPECT_LT((Of{"limiting-friction", {}, "box", Quantity::x}.allows(stated)), breaks / 100);
  EXPECT_LT((Of{"limiting-friction", {{"margin", -5e-5}}, "box", Quantity::x}.allows(stated)), breaks / 100);
}

}  // namespace
}  // namespace plumb::limiting_friction_test
