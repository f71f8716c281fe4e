#include "solver/energy_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::energy_bound_test {
namespace {

// Two bodies of 1 kg and .5 kg m^2, each 1 m from the middle, that fall freely: what they have from their centre of
// mass is 3/2 w^2 J if they turn as one and v^2 J if they part. At first they turn at 1 rad/s.
class Couple : public testing::Test {
 protected:
  Couple() {
    for (const Real x : {Real{-1}, Real{1}}) {
      start.push_back({{x, 0}, {}});
      bodies.inverse_mass.push_back({1, 2});
    }
    bodies.velocity.resize(2);
    motion.resize(2);
    acceleration.resize(2, {{0, -10}, 0});
    move(1, 0);
    bound.note(island, false, bodies, motion);
  }

  void move(Real w, Real v) {
    bodies.velocity[0] = {{-v, -10 - w}, w};
    bodies.velocity[1] = {{v, -10 + w}, w};
  }
  bool keep() { return bound.keep(bodies, start, motion, acceleration, 0); }
  /// That they turn as one at `w` and part at `v`.
  void expect(Real w, Real v) const {
    const Real error = std::numeric_limits<Real>::epsilon() * 32;
    for (int i = 0; i < 2; ++i) {
      const Velocity& velocity = bodies.velocity[static_cast<std::size_t>(i)];
      const Real side = i == 0 ? -1 : 1;
      EXPECT_NEAR(velocity.v.x, side * v, error);
      EXPECT_NEAR(velocity.v.y, -10 + side * w, error);
      EXPECT_NEAR(velocity.w, w, error);
    }
  }

  const std::vector<std::uint32_t> island{0, 1};
  std::vector<Pose> start;
  BodySet bodies;
  std::vector<Motion> motion;
  std::vector<Velocity> acceleration;
  EnergyBound bound;
};

using EnergyBoundOfACouple = Couple;

TEST_F(EnergyBoundOfACouple, LetsMotionsBeThatHaveNoMoreEnergyThanBefore) {
  move(real(.9), real(.3));
  EXPECT_FALSE(keep());
  expect(real(.9), real(.3));
}

TEST_F(EnergyBoundOfACouple, SlowsWhatMovesWithinAnIslandBeforeItsSpin) {
  move(real(.8), 2);
  EXPECT_TRUE(keep());
  expect(real(.8), std::sqrt(real(1.5 - 1.5 * .64)));
}

TEST_F(EnergyBoundOfACouple, SlowsTheSpinOfAnIslandThatHasTooMuchWithoutAnythingElse) {
  move(3, 2);
  EXPECT_TRUE(keep());
  expect(1, 0);
}

// A quarter turn later what was turning is parting.
TEST_F(EnergyBoundOfACouple, TellsSpinWhereBodiesAreNow) {
  motion[0].d = {1, -1};
  motion[1].d = {-1, 1};
  bodies.velocity = {{{2, -10}, 2}, {{-2, -10}, 2}};
  EXPECT_TRUE(keep());
  EXPECT_NEAR(bodies.velocity[1].v.x, -1, std::numeric_limits<Real>::epsilon() * 32);
  EXPECT_NEAR(bodies.velocity[1].w, 1, std::numeric_limits<Real>::epsilon() * 32);
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
