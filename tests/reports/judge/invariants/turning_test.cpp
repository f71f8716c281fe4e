#include <gtest/gtest.h>

#include <cmath>

#include "forged_runs.h"
#include "scenarios/scene/mass.h"

namespace plumb::turning_test {
namespace {

constexpr double dt = 0.001;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

// A box of 1 m and 1 kg, turned by 30 degrees, that falls on its lowest corner: the impulse J gives it J/m and, with
// the arm x of the corner, x J/I.
constexpr double tilt = 0.5235987755982988;                                  // rad
const double lowest = std::cos(tilt - 0.7853981633974483) / std::sqrt(2.0);  // m, of the corner below the centre
const double arm = std::sin(tilt - 0.7853981633974483) / std::sqrt(2.0);     // m, of the corner beside it

Trace landed(double impulse, double spin, double slope = tilt) {
  const auto box = [&](double vy, double w) {
    return std::vector<BodyState>{
        {}, {.position = {0, lowest}, .angle = slope, .velocity = {0, vy}, .angular_velocity = w}};
  };
  return forged(dt, {{box(-1, 0)}, {box(-1 + impulse, spin)}});
}

TEST(TurningInvariant, HoldsForABoxThatItsCornerTurns) {
  EXPECT_LT(arm, -0.1);
  EXPECT_EQ(status("turning", box_on_ground(), landed(0.5, 6 * arm * 0.5), exact), CheckStatus::held);
}

TEST(TurningInvariant, IsBrokenByABoxThatDoesNotTurn) {
  const auto check = checked("turning", box_on_ground(), landed(0.5, 0), exact).value();
  EXPECT_EQ(check.status, CheckStatus::broken);
  EXPECT_EQ(check.where, "box");
}

TEST(TurningInvariant, IsBrokenByABoxThatTurnsTheOtherWay) {
  EXPECT_EQ(status("turning", box_on_ground(), landed(0.5, -6 * arm * 0.5), exact), CheckStatus::broken);
}

TEST(TurningInvariant, IsBrokenByTheWrongInertia) {
  EXPECT_EQ(status("turning", box_on_ground(), landed(0.5, 1.1 * 6 * arm * 0.5), exact), CheckStatus::broken);
}

// A disc that is braked 4 mm above the ground, by impulses at the middle of the gap: their arm is 2 mm longer.
TEST(TurningInvariant, TakesPointsBetweenSurfacesOfAMethodThatBrakesEarly) {
  constexpr double gap = 0.004;
  Scene scene = box_on_ground(0.5);
  scene.bodies[1].shapes[0].geometry = Circle{.radius = 0.5};
  const Mass mass = mass_of(scene.bodies[1]);
  const auto braked = [&](double reach) {
    std::vector<BodyState> then = box_at({0, 0.5 + gap}, {1, -5});
    std::vector<BodyState> now = box_at({dt, 0.5}, {0.5, -4});
    now[1].angular_velocity = -0.5 * mass.mass * reach / mass.inertia;
    return forged(dt, {{then}, {now}});
  };
  Stepping stated = exact;
  EXPECT_EQ(status("turning", scene, braked(0.5 + gap / 2), stated), CheckStatus::broken);
  stated.impact_lead = 1;
  EXPECT_EQ(status("turning", scene, braked(0.5 + gap / 2), stated), CheckStatus::held);
  EXPECT_EQ(status("turning", scene, braked(0.5 + 4 * gap), stated), CheckStatus::broken);
}

// Flat on the ground, the load may be anywhere along its lower side: up to half a metre beside the centre.
TEST(TurningInvariant, LetsTheLoadBeAnywhereUnderAFlatBox) {
  const auto pushed = [](double spin) {
    return forged(
        dt, {{box_at({0, 0.5})}, {{{}, {.position = {0, 0.5}, .velocity = {0, 0.01}, .angular_velocity = spin}}}});
  };
  EXPECT_EQ(status("turning", box_on_ground(), pushed(6 * 0.5 * 0.01), exact), CheckStatus::held);
  EXPECT_EQ(status("turning", box_on_ground(), pushed(-6 * 0.5 * 0.01), exact), CheckStatus::held);
  EXPECT_EQ(status("turning", box_on_ground(), pushed(6 * 0.8 * 0.01), exact), CheckStatus::broken);
}

// Friction of .3 N s at the rim of a disc of 1 m: the centre slows down, and it rolls.
TEST(TurningInvariant, TurnsADiscByFriction) {
  Scene scene = box_on_ground();
  scene.bodies[1].shapes[0].geometry = Circle{.radius = 1};
  const Mass mass = mass_of(scene.bodies[1]);
  const auto slowed = [&](double spin) {
    return forged(dt, {{box_at({0, 1}, {1, -1})},
                       {{{}, {.position = {0, 1}, .velocity = {1 - 0.3 / mass.mass, 0}, .angular_velocity = spin}}}});
  };
  EXPECT_EQ(status("turning", scene, slowed(-0.3 / mass.inertia), exact), CheckStatus::held);
  EXPECT_EQ(status("turning", scene, slowed(0), exact), CheckStatus::broken);
  EXPECT_EQ(status("turning", scene, slowed(-0.4 / mass.inertia), exact), CheckStatus::broken);
}

TEST(TurningInvariant, SaysNothingOfABodyBetweenTwoOthers) {
  Scene scene = box_on_ground();
  scene.bodies.push_back({.name = "top", .position = {0, 1.5}, .shapes = {{Box{}, scene.bodies[1].shapes[0].surface}}});
  const BodyState top{.position = {0, 1.5}};
  const Trace trace =
      forged(dt, {{{{}, {.position = {0, 0.5}}, top}}, {{{}, {.position = {0, 0.5}, .velocity = {0.01, 0}}, top}}});
  EXPECT_EQ(status("turning", scene, trace, exact), CheckStatus::held);
}

}  // namespace
}  // namespace plumb::turning_test
