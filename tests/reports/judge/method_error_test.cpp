#include "reports/judge/method_error.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/run/run.h"
#include "reports/run/selection.h"

namespace plumb::method_error_test {
namespace {

constexpr double g = 10;
constexpr double dt = 1.0 / 120;

const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .order = 1, .impact_lag = 1};
const Stepping second_order{.dt = dt, .h = dt, .order = 2, .order_in_contact = 2, .impact_lag = 0};

std::vector<Stress> stress_of(const char* word) {
  const Case one = parse_cases(word).front();
  return stress_along(*one.scene, *run(*one.scene, parse_engine("impulse"), dt).trace);
}

TEST(MethodError, IsTheDriftOfFreeFall) {
  const Stress falling = stress_of("bounce:e=0.8")[60];
  EXPECT_NEAR(method_error(first_order, falling, true).place, g * 0.5 * dt / 2, 1e-9);
  EXPECT_NEAR(method_error(second_order, falling, true).place, 0, 1e-9);
}

TEST(MethodError, AddsTheLagOfAnImpact) {
  const std::vector<Stress> all = stress_of("bounce:e=0.8");
  const Stress& bounced = all[132];  // lands at .894 s with 8.94 m/s
  EXPECT_NEAR(bounced.pushed, 1.8 * 8.94, 0.1);
  EXPECT_NEAR(method_error(first_order, bounced, false).place - dt / 2 * bounced.smooth, dt * bounced.pushed, 1e-9);
}

TEST(MethodError, HasAGapForEveryBodyThatTouches) {
  const Stress resting = stress_of("stacking:ten").back();
  EXPECT_EQ(resting.contacts, 10);
  Stepping soft = second_order;
  soft.skin = 0.01;
  EXPECT_NEAR(method_error(soft, resting, false).place - method_error(second_order, resting, false).place, 0.1, 1e-12);
}

TEST(MethodError, LosesTheSpeedOfAnImpactBelowTheThreshold) {
  const Stress bounced = stress_of("bounce:e=0.8")[132];
  for (const auto& [threshold, lost] : {std::pair{7.0, 0.0}, {9.0, 9.0}}) {
    Stepping dull = second_order;
    dull.restitution_threshold = threshold;
    EXPECT_NEAR(method_error(dull, bounced, true).speed - method_error(second_order, bounced, true).speed, lost, 1e-12);
  }
}

// At rest until it is hit, and then on a circle: no contact explains that its acceleration goes on.
TEST(MethodError, CountsAChangeOfAccelerationFromBeforeToAfterAContact) {
  const std::vector<Stress> all = stress_of("hinged-hit:e=0.5");
  const double moment = 0.393;  // s, of the impact
  const auto before = static_cast<std::size_t>(moment / dt);
  EXPECT_EQ(all[before].bends, 0);
  EXPECT_EQ(all[before].jolts, 0);
  EXPECT_GT(all[before + 4].bends, 1);
  EXPECT_GT(all[before + 5].jolts, 1);
}

TEST(MethodError, TurnsTheChangeOfVelocityInAJamByTheRotationOfAStep) {
  const Stress jammed = stress_of("painleve-rod:mu=2")[12];
  EXPECT_EQ(jammed.jammed, 0) << "it jams in the first step: no method is late";
  EXPECT_NEAR(jammed.turned, 4.16 * 3.17 * 11 * dt, 0.2);
  Stress without = jammed;
  without.turned = 0;
  const double error =
      method_error(second_order, jammed, false).place - method_error(second_order, without, false).place;
  EXPECT_NEAR(error, dt * jammed.turned, 1e-12);
}

TEST(MethodError, HalvesWithTheStepAtFirstOrderAndQuartersAtSecond) {
  const Stress swinging = stress_of("double-pendulum:wild")[60];
  Stepping half = first_order;
  half.h = dt / 2;
  EXPECT_NEAR(method_error(half, swinging, false).place, method_error(first_order, swinging, false).place / 2, 1e-12);
  half = second_order;
  half.h = dt / 2;
  EXPECT_NEAR(method_error(half, swinging, false).place, method_error(second_order, swinging, false).place / 4, 1e-12);
}

// a = a_0 exp(-t/T) pushes for a moment and is gone. The trapezoidal rule makes the speed wrong by h^2/12 (a_0/T), and
// what flies on goes on to stray.
TEST(MethodError, GrowsWhereSomethingFliesOnAfterAForceHasCeased) {
  constexpr double at_first = 10;  // m/s^2
  constexpr double ends = 0.1;     // s
  const auto pushed = [](double t) { return at_first * std::exp(-t / ends); };
  const auto speed = [](double t) { return at_first * ends * (1 - std::exp(-t / ends)); };
  const Scene scene{.bodies = {{.name = "disc", .shapes = {{Circle{0.1}, {}}}}}};
  Trace trace(1);
  double x = 0;
  double v = 0;
  for (int step = 0; step <= 120; ++step) {
    const double t = dt * step;
    trace.record(t, std::vector<BodyState>{{.velocity = {speed(t), 0}}}, {});
    x += dt * (v + dt / 2 * pushed(t));
    v += dt / 2 * (pushed(t) + pushed(t + dt));
  }
  const double t = 121 * dt;
  const double off = std::abs(x - at_first * ends * (t - ends * (1 - std::exp(-t / ends))));
  const double allowed = method_error(second_order, stress_along(scene, trace).back(), false).place;
  EXPECT_GT(off, 9 * dt * dt);
  EXPECT_GT(allowed, off);
  EXPECT_LT(allowed, 1.5 * off);
}

constexpr double frame = 1.0 / 60;

double most_in(const char* word) {
  const Case one = parse_cases(word).front();
  double most = 0;
  for (const auto& bodies : jams_in(*one.scene, *run(*one.scene, parse_engine("impulse"), frame).trace)) {
    for (const double jam : bodies) most = std::max(most, jam);
  }
  return most;
}

// The foot of the rod stops at once, though it never approached the ground: v = w r, w = (r x v)/(k^2 + r^2) = 3.18
// rad/s, with r = (.53, -.853) m, which is a jump of 4.26 m/s. A frame's fall, .17 m/s, is in it or not, and what may
// be a load's, as much again, is taken from it.
TEST(Jams, AreFoundWhereFrictionAndRigidityContradictEachOther) {
  constexpr double fall = 10 * frame;
  EXPECT_NEAR(most_in("painleve-rod:mu=2"), 4.26 - fall, fall);
  EXPECT_GT(most_in("painleve-rod:mu=5"), 4);
}

TEST(Jams, AreNoImpactsOfBodiesThatApproach) {
  for (const char* word : {"bounce:e=0.5", "head-on:e=0", "off-center", "dominoes:ten"})
    EXPECT_EQ(most_in(word), 0) << word;
}

TEST(Jams, AreNoLoadsThatComeAndGo) {
  for (const char* word : {"stacking:ten", "dome:slips", "step-climb:over", "stick-slip:fast"})
    EXPECT_EQ(most_in(word), 0) << word;
}

}  // namespace
}  // namespace plumb::method_error_test
