#include "solver/energy_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::energy_bound_test {
namespace {

// What it turns as a whole is bound, too: errors of welds that are swept one by one made a star spin ever faster.
TEST(EnergyBound, KeepsAStarOfWeldsFromGainingSpeed) {
  constexpr int beads = 64;
  Settings settings = accurate();
  settings.gravity = {};
  World world(settings);
  const BodyId hub = world.create_body(at(0, 0, 0, 0, 2), Shape::circle(1), material(0));
  for (int i = 0; i < beads; ++i) {
    const double angle = 2 * 3.14159265358979 * i / beads;
    const double x = 2 * std::cos(angle);
    const double y = 2 * std::sin(angle);
    const BodyId bead = world.create_body(at(x, y, -2 * y, 2 * x, 2), Shape::circle(real(.05)), material(0));
    world.create_joint(WeldJoint{hub, bead, vec(x, y)});
  }
  const double before = energy(world);
  run(world, 300);
  EXPECT_LT(energy(world), (1 + bound(1e-4, 1e-3)) * before);
}

TEST(Descent, EndsWithoutExcess) {
  Descent descent(10);
  EXPECT_TRUE(descent.goes_on(Real{1}));
  EXPECT_TRUE(descent.goes_on(Real{0.5F}));
  EXPECT_FALSE(descent.goes_on(Real{0}));
}

TEST(Descent, UsesNoMoreThanItsIterations) {
  Descent descent(2);
  EXPECT_TRUE(descent.goes_on(Real{8}));
  EXPECT_TRUE(descent.goes_on(Real{4}));
  EXPECT_FALSE(descent.goes_on(Real{2}));
}

// 1 of 8 in each iteration: seven more suffice, six do not.
TEST(Descent, ContinuesWhileTheRemainingIterationsMaySuffice) {
  for (const auto& [sweeps, hopeful] : {std::pair{8, true}, std::pair{7, false}}) {
    Descent descent(sweeps);
    EXPECT_TRUE(descent.goes_on(Real{8}));
    EXPECT_EQ(descent.goes_on(Real{7}), hopeful) << sweeps;
  }
}

TEST(Descent, EndsIfTheExcessGrows) {
  Descent descent(60);
  EXPECT_TRUE(descent.goes_on(Real{1}));
  EXPECT_FALSE(descent.goes_on(Real{2}));
}

TEST(Descent, EndsWithNan) { EXPECT_FALSE(Descent(60).goes_on(std::numeric_limits<Real>::quiet_NaN())); }

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::energy_bound_test
