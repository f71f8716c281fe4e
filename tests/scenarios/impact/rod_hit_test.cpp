#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::rod_hit_test {
namespace {

using statement_of::Of;

double expected(const std::string& family, const Parameters& changes, const std::string& body, Quantity quantity) {
  return *Of{family, changes, body, quantity}.expectations().front().expected;
}

struct Bodies {
  Parameters p;
  Mass rod, striker;
};

Bodies bodies_of(const std::string& name, const Parameters& changes) {
  const Scenario& family = *Catalog<Scenario>::find(name);
  const Parameters p = complete(family, changes);
  const Scene scene = family.scene(p);
  return {p, mass_of(scene.bodies[0]), mass_of(scene.bodies[1])};
}

// Momentum, angular momentum about the rod's centre, and the velocities of the points that meet: three equations for
// three unknowns, none of them the closed form.
TEST(RodHit, KeepsBothMomentaAndSeparatesWithItsRestitution) {
  for (const Parameters& changes : std::vector<Parameters>{
           {}, {{"restitution", 1}, {"offset", 0.3}, {"ratio", 2}}, {{"offset", 0.9}, {"ratio", 0.3}}}) {
    const auto [p, rod, striker] = bodies_of("rod-hit", changes);
    const double v = p.at("speed");
    const double d = p.at("offset");
    const double rises = expected("rod-hit", changes, "rod", Quantity::vy);
    const double spin = expected("rod-hit", changes, "rod", Quantity::angular_velocity);
    const double left = expected("rod-hit", changes, "disc", Quantity::vy);
    EXPECT_NEAR(rod.mass * rises + striker.mass * left, striker.mass * v, 1e-12);
    EXPECT_NEAR(rod.inertia * spin + striker.mass * d * left, striker.mass * d * v, 1e-12);
    EXPECT_NEAR(rises + spin * d - left, p.at("restitution") * v, 1e-12);
  }
}

TEST(HingedHit, KeepsAngularMomentumAboutTheHingeAndSeparatesWithItsRestitution) {
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"distance", 0.6}, {"ratio", 0.3}}}) {
    const auto [p, rod, striker] = bodies_of("hinged-hit", changes);
    const double v = p.at("speed");
    const double d = p.at("distance");
    const double spin = expected("hinged-hit", changes, "rod", Quantity::angular_velocity);
    const double left = expected("hinged-hit", changes, "disc", Quantity::vy);
    EXPECT_NEAR((rod.inertia + rod.mass) * spin + striker.mass * d * left, striker.mass * d * v, 1e-12);
    EXPECT_NEAR(spin * d - left, p.at("restitution") * v, 1e-12);
  }
}

// Struck at the centre of percussion, a free rod turns about its other end: a hinge there makes no difference.
TEST(HingedHit, IsThatOfAFreeRodWhereTheHingeFeelsNothing) {
  const double offset = (4 + 0.04) / 12;
  const Parameters common{{"restitution", 0.8}, {"ratio", 0.5}};
  Parameters free = common;
  free["offset"] = offset;
  Parameters hinged = common;
  hinged["distance"] = 1 + offset;
  EXPECT_NEAR(expected("hinged-hit", hinged, "rod", Quantity::angular_velocity),
              expected("rod-hit", free, "rod", Quantity::angular_velocity), 1e-12);
  EXPECT_NEAR(expected("hinged-hit", hinged, "disc", Quantity::vy), expected("rod-hit", free, "disc", Quantity::vy),
              1e-12);
}

// With the inertia of a thin hoop of its length, m L^2/4, the rod would turn a third as fast.
TEST(RodHit, StopsARodOfWrongInertia) {
  const Of spin{"rod-hit", {}, "rod", Quantity::angular_velocity};
  EXPECT_LT(spin.allows_at_most(), *spin.expectations().front().expected / 1000);
  const Of hinged{"hinged-hit", {}, "rod", Quantity::angular_velocity};
  EXPECT_LT(hinged.allows_at_most(), *hinged.expectations().front().expected / 10);
}

// Momentum, angular momentum about the struck one's centre and, as e = 1, energy: three laws for three unknowns.
TEST(Capsules, KeepMomentumAngularMomentumAndTheEnergyOfAnElasticImpact) {
  const Scenario& scenario = *Catalog<Scenario>::find("capsules");
  const Parameters p = complete(scenario, {{"restitution", 1}});
  const Scene scene = scenario.scene(p);
  const Mass struck = mass_of(scene.bodies[0]);
  const Mass falling = mass_of(scene.bodies[1]);
  const auto all = scenario.expectations(p);
  const double up = *all[0].expected;
  const double down = *all[1].expected;
  const double spin = *all[2].expected;
  const double v = -p.at("speed");
  EXPECT_LT(spin, 0) << "pushed down on its right";
  EXPECT_NEAR(falling.mass * up + struck.mass * down, falling.mass * v, 1e-12);
  EXPECT_NEAR(falling.mass * p.at("offset") * up + struck.inertia * spin, falling.mass * p.at("offset") * v, 1e-12);
  EXPECT_NEAR(falling.mass * up * up + struck.mass * down * down + struck.inertia * spin * spin, falling.mass * v * v,
              1e-12);
}

}  // namespace
}  // namespace plumb::rod_hit_test
