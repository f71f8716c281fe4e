#include <gtest/gtest.h>

#include <cmath>

#include "tests/reports/invariants/holding.h"

// Those that are told from the contacts shown.
namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .epsilon = 1e-16};

Trace shown(const std::vector<ContactState>& contacts, Vec velocity = {}) {
  return forged(dt, {{box_at({0, 0.5}, velocity), contacts}, {box_at({0, 0.5}, velocity), contacts}});
}

TEST(ContactInvariants, NeverPassWhatIsNotRevealed) {
  const Scene scene = box_on_ground();
  for (const char* name : {"push", "cone", "complementarity", "sticking", "momentum_of_bodies"}) {
    EXPECT_EQ(standing(name, scene, shown({}), exact), Standing::not_revealed) << name;
  }
  Stepping parts = exact;
  parts.whole_impulses = false;
  for (const char* name : {"cone", "sticking", "momentum_of_bodies"}) {
    EXPECT_EQ(standing(name, scene, shown({pushing(1)}), parts), Standing::not_revealed) << name;
  }
}

TEST(PushInvariant, ForbidsPullingByMoreThanRoundOff) {
  const Scene scene = box_on_ground();
  EXPECT_EQ(standing("push", scene, shown({pushing(1), pushing(-6e-15)}), exact), Standing::held);
  const auto broken = checked("push", scene, shown({pushing(1), pushing(-7e-15)}), exact).value();
  EXPECT_EQ(broken.standing, Standing::broken);
  EXPECT_EQ(broken.where, "ground - box");
}

TEST(ConeInvariant, HoldsFrictionToItsCoefficient) {
  const Scene scene = box_on_ground(0.5);
  EXPECT_EQ(standing("cone", scene, shown({pushing(2, -1)}), exact), Standing::held);
  EXPECT_EQ(standing("cone", scene, shown({pushing(2, -1 - 1e-14)}), exact), Standing::held);
  EXPECT_EQ(standing("cone", scene, shown({pushing(2, -1 - 2e-14)}), exact), Standing::broken);
}

TEST(ConeInvariant, LetsAFirstOrderMethodTakeThePushOfTheStepBefore) {
  const Scene scene = box_on_ground(0.5);
  const auto falling_off = [](double tangent) {
    return forged(dt, {{box_at({0, 0.5}), {pushing(3, 1)}}, {box_at({0, 0.5}), {pushing(2, tangent)}}});
  };
  EXPECT_EQ(standing("cone", scene, falling_off(1.499), first_order), Standing::held);
  EXPECT_EQ(standing("cone", scene, falling_off(1.501), first_order), Standing::broken);
  EXPECT_EQ(standing("cone", scene, falling_off(1.499), exact), Standing::broken);
}

TEST(ComplementarityInvariant, ForbidsAPushFromAfar) {
  const Scene scene = box_on_ground();
  const auto apart = [](double gap) {
    return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5 + gap}), {pushing(1)}}});
  };
  Stepping with_gap = exact;
  with_gap.gap = 0.01;
  // Twice the gap, and what 1 N s gives 1 kg in 0.01 s.
  EXPECT_EQ(standing("complementarity", scene, apart(0.0299), with_gap), Standing::held);
  EXPECT_EQ(standing("complementarity", scene, apart(0.0301), with_gap), Standing::broken);
}

TEST(StickingInvariant, ForbidsToSlideWithFrictionToSpare) {
  const Scene scene = box_on_ground(0.5);
  // The impulse itself changes a speed by hypot(1, 0.25) (1 + 0.5^2 6) m/s at the contact, 0.5 m from the centre.
  const auto sliding = [&](double speed, double tangent) { return shown({pushing(1, tangent)}, {speed, 0}); };
  const double allowed = std::hypot(1, 0.25) * (1 + 6 * 0.25);
  EXPECT_EQ(standing("sticking", scene, sliding(0.99 * allowed, 0.25), exact), Standing::held);
  EXPECT_EQ(standing("sticking", scene, sliding(1.01 * allowed, 0.25), exact), Standing::broken);
  EXPECT_EQ(standing("sticking", scene, sliding(100, 0.5), exact), Standing::held);
}

TEST(BodyMomentumInvariant, HoldsBodiesToTheImpulsesShown) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto moved = [&](double vy) {
    return forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, vy}), {pushing(1.1, 0)}}});
  };
  EXPECT_EQ(standing("momentum_of_bodies", scene, moved(0), exact), Standing::held);
  EXPECT_EQ(standing("momentum_of_bodies", scene, moved(2e-14), exact), Standing::held);
  const auto broken = checked("momentum_of_bodies", scene, moved(1e-12), exact).value();
  EXPECT_EQ(broken.standing, Standing::broken);
  EXPECT_EQ(broken.where, "box");
}

}  // namespace
}  // namespace plumb
