#include <gtest/gtest.h>

#include <algorithm>
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

constexpr double pull = 4 * std::numbers::pi * std::numbers::pi;  // 1/s^2: k/m

// Small steps with Coulomb's law in each: friction stops the block if it can, else it brakes with mu g.
double slid(double amplitude, double mu, double time) {
  constexpr double dt = 1e-6;
  double x = amplitude;
  double v = 0;
  for (int i = 0, steps = static_cast<int>(std::lround(time / dt)); i < steps; ++i) {
    const double free = v - pull * x * dt;
    const double most = mu * 10 * dt;
    v = std::abs(free) <= most ? 0 : free - std::copysign(most, free);
    x += v * dt;
  }
  return x;
}

TEST(DryOscillator, AgreesWithSmallStepsOfCoulombsLaw) {
  for (const Parameters& changes : std::vector<Parameters>{
           {}, {{"friction", 0.9}}, {{"friction", 0.25}, {"amplitude", 0.7}}, {{"friction", 1}, {"amplitude", 2}}}) {
    const Parameters p = complete(*Catalog<Scenario>::find("dry-oscillator"), changes);
    double last = 0;
    for (const Expectation& one : Of{"dry-oscillator", changes, "block", Quantity::x}.expectations()) {
      last = one.time.value_or(last + 1);
      EXPECT_NEAR(*one.expected, slid(p.at("amplitude"), p.at("friction"), last), 1e-4) << last;
    }
  }
}

// Without friction the block would be at the full amplitude after each half period; with viscous damping it would lose
// a share of it, not a length: 0.08 m less in the third swing than in the first.
TEST(DryOscillator, StopsAFrictionlessOneAndViscousDamping) {
  const double lost = 2 * 0.4 * 10 / pull;  // m, in each half period
  EXPECT_LT((Of{"dry-oscillator", {}, "block", Quantity::x, 0.6}.allows_at_most()), lost / 2);
  EXPECT_LT((Of{"dry-oscillator", {}, "block", Quantity::x}.allows(statement_of::accurate())), lost / 20);
}

}  // namespace
}  // namespace plumb::stick_slip_test
