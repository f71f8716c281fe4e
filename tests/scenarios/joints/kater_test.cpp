#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::kater_test {
namespace {

using statement_of::Of;

// I angle'' = -m g d sin(angle), with the scene's own distances and masses.
TEST(Kater, HasRodsThatSwingWithAPeriodOfTwoSecondsFromBothHinges) {
  const Scenario& family = *Catalog<Scenario>::find("kater");
  for (const double degrees : {5.0, 30.0, 60.0}) {
    const Scene scene = family.scene(complete(family, {{"angle", degrees}}));
    const double start = degrees * std::acos(-1) / 180;
    for (const std::size_t i : {1u, 2u}) {
      const Body& rod = scene.bodies[i];
      const Vec hinge{i == 1 ? 0.0 : 4.0, 0};
      const double d = std::hypot(rod.position.x - hinge.x, rod.position.y - hinge.y);
      const Mass mass = mass_of(rod);
      const double w2 = mass.mass * 10 * d / (mass.inertia + mass.mass * d * d);
      const auto rate = [&](const std::array<double, 2>& y) {
        return std::array<double, 2>{y[1], -w2 * std::sin(y[0])};
      };
      EXPECT_NEAR(integrated(std::array<double, 2>{start, 0}, 0.5, 5000, rate)[0], 0, 1e-9) << rod.name;
      EXPECT_NEAR(integrated(std::array<double, 2>{start, 0}, 1, 5000, rate)[0], -start, 1e-9) << rod.name;
      EXPECT_NEAR(*(Of{"kater", {{"angle", degrees}}, rod.name, Quantity::angle}.expectations()[1].expected), -start,
                  1e-12);
    }
    EXPECT_GT(std::abs(scene.bodies[1].position.y - scene.bodies[2].position.y), 0.1) << "not conjugate but equal";
  }
}

// Taken for points, the rods have the periods of d: the near one a third of a second less.
TEST(Kater, StopsRodsWithoutInertia) {
  const Of angle{"kater", {}, "near", Quantity::angle, 0.6};
  EXPECT_LT(angle.allows_at_most(), 0.5 * std::acos(-1) / 6);
}

}  // namespace
}  // namespace plumb::kater_test
