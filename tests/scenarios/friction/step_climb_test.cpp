#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/scenarios/statement_of.h"

namespace plumb::step_climb_test {
namespace {

using statement_of::Of;

constexpr double gravity = 10;
constexpr double radius = 1;
constexpr double height = 0.2;

double expected_x(double speed) {
  return *Of{"step-climb", {{"speed", speed}}, "disc", Quantity::x}.expectations().back().expected;
}

// It keeps (1 + 2 cos a)/3 of its speed and must climb the step: 3/4 v'^2 = g h.
TEST(StepClimb, TurnsBackBelowTheLeastSpeed) {
  const double kept = (1 + 2 * (1 - height / radius)) / 3;
  const double least = std::sqrt(4.0 / 3 * gravity * height) / kept;
  EXPECT_GT(expected_x(1.02 * least), 0);
  EXPECT_LT(expected_x(0.98 * least), -0.6);
}

// The time about the edge is the integral of da/w with 3/4 (r w)^2 = 3/4 v'^2 - g r (cos a - cos a0).
TEST(StepClimb, TakesTheTimeThatItsEnergyGives) {
  for (const double speed : {2.25, 2.5}) {
    const double first = std::acos(1 - height / radius);
    const double kept = (1 + 2 * std::cos(first)) / 3 * speed;
    const auto speed_at = [&](double a) {
      return std::sqrt(kept * kept - 4.0 / 3 * gravity * radius * (std::cos(a) - std::cos(first)));
    };
    constexpr int steps = 100000;
    double time = 0;
    for (int i = 0; i < steps; ++i) time += first / steps * radius / speed_at(first * (i + 0.5) / steps);
    const double met = (2.4 - radius * std::sin(first)) / speed;
    for (const Expectation& one : Of{"step-climb", {{"speed", speed}}, "disc", Quantity::x}.expectations()) {
      const double end = one.time.value();
      EXPECT_NEAR(*one.expected, speed_at(0) * (end - met - time), 1e-7) << speed;
    }
  }
}

// A disc that falls back is at the edge again with the speed it had there, and loses the same share at the floor.
TEST(StepClimb, LosesTwiceWhatAnEdgeTakesOnTheWayBack) {
  const std::vector<Expectation> all = Of{"step-climb", {{"speed", 1.4}}, "disc", Quantity::x}.expectations();
  const double kept = (1 + 2 * (1 - height / radius)) / 3;
  const double between = *all.back().time - *all.front().time;
  EXPECT_NEAR((*all.back().expected - *all.front().expected) / between, -1.4 * kept * kept, 1e-9);
}

// One that keeps its speed at the edge climbs the step with 1.65 m/s, 3/4 v^2 > g h; one that slides has no angle.
TEST(StepClimb, StopsAnEngineThatSlidesOrLosesNothingAtTheEdge) {
  ASSERT_GT(0.75 * 1.65 * 1.65, gravity * height);
  EXPECT_LT((Of{"step-climb", {{"speed", 1.65}}, "disc", Quantity::y}.allows_at_most()), height / 4);
  const Expectation angle = Of{"step-climb", {}, "disc", Quantity::angle}.expectations().back();
  for (const Stepping& stated : statement_of::all())
    EXPECT_LT(angle.allowed(stated), std::abs(*angle.expected) * 2 / 3);
}

}  // namespace
}  // namespace plumb::step_climb_test
