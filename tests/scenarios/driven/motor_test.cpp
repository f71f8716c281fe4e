#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::motor_test {
namespace {

using statement_of::Of;

struct Turned {
  double angle = 0;  // rad
  double speed = 0;  // rad/s
};

/// What a wheel has turned by after `time`, s, in small steps, in which what drives it to `speed`, rad/s, by at most
/// `acceleration`, rad/s^2, is cut where it would pass that speed. At the angle `stop` it stays for good.
Turned turned(double speed, double acceleration, double time, double stop = std::numeric_limits<double>::infinity()) {
  constexpr int steps = 100000;
  const double h = time / steps;
  Turned wheel;
  for (int i = 0; i < steps; ++i) {
    const double before = wheel.speed;
    wheel.speed += std::clamp(speed - wheel.speed, -acceleration * h, acceleration * h);
    wheel.angle += h * (before + wheel.speed) / 2;
    if (std::abs(wheel.angle) > stop) wheel.speed = 0;
  }
  return wheel;
}

// A disc of 0.5 m and 1 kg/m^2.
TEST(Motor, AgreesWithAnIntegrationInSmallSteps) {
  constexpr double inertia = std::numbers::pi * 0.0625 / 2;
  for (const auto& [speed, torque] : {std::pair{2.0, 0.1}, std::pair{-6.0, 1.0}, std::pair{8.0, 0.1}}) {
    const Parameters changes{{"speed", speed}, {"torque", torque}};
    for (const Quantity quantity : {Quantity::angle, Quantity::angular_velocity}) {
      for (const Expectation& one : (Of{"motor", changes, "wheel", quantity}.expectations())) {
        const Turned wheel = turned(speed, torque / inertia, *one.time);
        EXPECT_NEAR(*one.expected, quantity == Quantity::angle ? wheel.angle : wheel.speed, 1e-6)
            << speed << ' ' << *one.time;
      }
    }
  }
}

// A wheel that rests, or one that has the motor's speed from the start.
TEST(Motor, StopsAMotorThatDoesNothingOrHasNoLimit) {
  const Of early{
      .scenario = "motor", .changes = {}, .body = "wheel", .quantity = Quantity::angular_velocity, .before = 2};
  EXPECT_LT(early.allows_at_most(), 1.0 / 10);
}

// Wheels of .15 m: to the left and to the right, freely and to a stop.
TEST(MotorHub, AgreesWithAnIntegrationInSmallSteps) {
  const double inertia = std::numbers::pi * std::pow(.15, 4) / 2;
  constexpr double torque = .002;
  for (const double stop : {0.0, 120.0}) {
    for (const auto& [wheel, speed] : {std::pair{"wheel 1", 4.0}, std::pair{"wheel 16", -4.0}}) {
      const double limit = stop > 0 ? stop * std::numbers::pi / 180 : std::numeric_limits<double>::infinity();
      const Turned expected = turned(speed, torque / inertia, 3, limit);
      const Parameters changes{{"stop", stop}};
      for (const Quantity quantity : {Quantity::angle, Quantity::angular_velocity}) {
        const auto all = Of{"motor-hub", changes, wheel, quantity}.expectations();
        ASSERT_EQ(all.size(), quantity == Quantity::angle ? 2 : 1);
        const double tolerance = quantity == Quantity::angle ? 2e-4 : 1e-3;  // a step's motion; its last torque
        EXPECT_NEAR(*all.back().expected, quantity == Quantity::angle ? expected.angle : expected.speed, tolerance)
            << wheel << ' ' << stop;
        if (quantity != Quantity::angle) continue;
        const double early = *all[0].time;
        EXPECT_NEAR(std::abs(*all[0].expected), torque / inertia * early * early / 2, 1e-12) << wheel << ' ' << stop;
      }
    }
  }
}

TEST(MotorHub, StopsMotorsOfOneSideAlone) {
  const Of hub{.scenario = "motor-hub", .changes = {}, .body = "hub", .quantity = Quantity::angle};
  const double turned = 15 * .002 * 3 * 3 / 2 / (std::numbers::pi * 8);  // rad, that 15 motors would turn it
  EXPECT_LT(hub.allows_at_most(), turned / 5);
}

// The brake's torque is constant until the arm stops for the first time.
TEST(MotorArm, StopsWhereAnIntegrationStops) {
  for (const double share : {0.5, 0.6, 0.9}) {
    constexpr double weight = 7.5;  // any: where it stops does not depend on it
    std::array<double, 2> state{1e-9, 0};
    const auto rate = [&](const std::array<double, 2>& y) {
      return std::array<double, 2>{y[1], weight * (std::cos(y[0]) - share)};
    };
    double t = 0;
    do {
      state = integrated(state, 1e-3, 1, rate);
      t += 1e-3;
    } while (state[1] > 0);
    EXPECT_LT(t, 5) << "the arm of half a metre is faster yet";
    EXPECT_LT(std::cos(state[0]), share);
    EXPECT_GT(std::cos(state[0]), -share) << "the motor can hold it there";
    EXPECT_NEAR(*(Of{"motor-arm", {{"share", share}}, "arm", Quantity::angle}.expectations().front().expected),
                -state[0], 1e-5);
  }
}

// By energy, w^2/2 = m g l/I (sin x - share x): the time to fall by x is the integral of 1/w. In u = sqrt(x), as 1/w
// has a pole at x = 0.
TEST(MotorArm, FallsInTheTimeThatItsEnergyGives) {
  constexpr double weight = 10 * 0.5 / (0.25 + (1 + 0.01) / 12);  // 1/s^2, of a plate of 1 m by .1 m about its end
  for (const double share : {0.5, 0.6, 0.9}) {
    const std::vector<Expectation> all = Of{"motor-arm", {{"share", share}}, "arm", Quantity::angle}.expectations();
    const double x = -*all.back().expected;
    constexpr int steps = 10000;
    double time = 0;
    for (int i = 0; i < steps; ++i) {
      const double u = (i + 0.5) / steps * std::sqrt(x);
      time += std::sqrt(x) / steps * 2 * u / std::sqrt(2 * weight * (std::sin(u * u) - share * u * u));
    }
    EXPECT_NEAR(time, *all.back().time, 1e-8) << share;
  }
}

TEST(MotorArm, HoldsAnArmThatItsTorqueBears) {
  EXPECT_EQ(*(Of{"motor-arm", {{"share", 1.02}}, "arm", Quantity::angle}.expectations().front().expected), 0);
}

// Without a motor the arm swings between level and level; with one of no limit it stays.
TEST(MotorArm, StopsAMotorThatDoesNothingOrHasNoLimit) {
  EXPECT_LT((Of{"motor-arm", {}, "arm", Quantity::angle}.allows_at_most()), 1.0 / 3);
  EXPECT_LT((Of{"motor-arm", {{"share", 1.02}}, "arm", Quantity::angle}.allows_at_most()), 0.05);
}

// In steps of 10 microseconds, the motor taking what it needs to hold its speed.
TEST(MotorLift, AgreesWithAnIntegrationInSmallSteps) {
  for (const Parameters& changes : std::vector<Parameters>{{}, {{"share", 3}, {"speed", 4}}, {{"share", 1.05}}}) {
    const Scenario& family = *Catalog<Scenario>::find("motor-lift");
    const Scene scene = family.scene(complete(family, changes));
    const Motor motor = *std::get<Revolute>(scene.joints[0]).motor;
    const Mass mass = mass_of(scene.bodies[1]);
    const double arm = -scene.bodies[1].position.y;
    const double inertia = mass.inertia + mass.mass * arm * arm;
    for (const Expectation& one : Of{"motor-lift", changes, "weight", Quantity::angle}.expectations()) {
      constexpr double h = 1e-5;
      double angle = 0;
      double spin = 0;
      const double end = one.time.value_or(scene.duration);
      for (int i = 0; i < std::lround(end / h); ++i) {
        const double load = mass.mass * 10 * arm * std::sin(angle);
        const double wanted = (motor.speed - spin) / h * inertia + load;
        const double torque = std::min(std::max(wanted, -motor.strength), motor.strength);
        const double next = spin + h * (torque - load) / inertia;
        angle += h * (spin + next) / 2;
        spin = next;
      }
      EXPECT_NEAR(*one.expected, angle, 2e-4);
    }
  }
}

// A motor that cannot lift the weight leaves it below the hinge's height, a quarter turn.
TEST(MotorLift, StopsAMotorThatIsTooWeak) {
  EXPECT_LT((Of{"motor-lift", {}, "weight", Quantity::angle}.allows_at_most()), std::acos(-1) / 2);
}

}  // namespace
}  // namespace plumb::motor_test
