#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::capsules_test {
namespace {

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
}  // namespace plumb::capsules_test
