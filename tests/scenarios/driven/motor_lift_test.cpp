#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::motor_lift_test {
namespace {

using statement_of::Of;

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
}  // namespace plumb::motor_lift_test
