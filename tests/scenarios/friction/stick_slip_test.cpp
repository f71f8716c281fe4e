#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/scenarios/statement_of.h"

namespace plumb::stick_slip_test {
namespace {

using statement_of::Of;

// Coulomb's law with two coefficients, in steps of some microseconds.
double place(double dynamic, double sticking, double speed, double drawn, double time) {
  constexpr double h = 2e-6;
  const double w = 2 * std::numbers::pi;
  double x = 0;
  double v = 0;
  bool sticks = true;
  for (double t = 0; t < time; t += h) {
    const double pull = w * w * (drawn + speed * t - x);
    if (sticks && std::abs(pull) <= 10 * sticking) continue;
    sticks = false;
    const double next = v + h * (pull - 10 * dynamic * (v < 0 ? -1 : 1));
    sticks = v > 0 && next <= 0;
    v = sticks ? 0 : next;
    x += h * v;
  }
  return x;
}

TEST(StickSlip, AgreesWithAnIntegrationInSmallSteps) {
  for (const auto& [dynamic, excess, speed] :
       {std::array{0.3, 0.3, 0.2}, std::array{0.3, 0.2, 0.4}, std::array{0.5, 0.15, 0.1}}) {
    const Parameters changes{{"dynamic", dynamic}, {"excess", excess}, {"speed", speed}};
    const double k = 4 * std::numbers::pi * std::numbers::pi;
    const double drawn = (dynamic - excess) * 10 / k;  // as after a slip
    for (const Expectation& one : (Of{"stick-slip", changes, "block", Quantity::x}.expectations())) {
      EXPECT_NEAR(*one.expected, place(dynamic, dynamic + excess, speed, drawn, *one.time), 2e-5) << *one.time;
    }
  }
}

// With one coefficient it slides along at the puller's speed: a slip less.
TEST(StickSlip, StopsABlockThatIsPulledAlong) {
  const std::vector<Expectation> rests = Of{"stick-slip", {}, "block", Quantity::x}.expectations();
  const double slip = *rests[2].expected - *rests[1].expected;
  EXPECT_LT(rests[1].allowed(statement_of::accurate()), slip / 20);
}

}  // namespace
}  // namespace plumb::stick_slip_test
