#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scenario.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::restitution_rules_test {
namespace {

using statement_of::Of;

double expected(double rule, Quantity quantity) {
  return *Of{"restitution-rules", {{"rule", rule}}, "disc", quantity}.expectations().front().expected;
}

// Of .9 and .4.
TEST(RestitutionRules, MixAsTheirNamesSay) {
  const double mixed[] = {0.9, 0.4, 0.65, 0.36};
  for (int rule = 0; rule < 4; ++rule) EXPECT_NEAR(expected(rule, Quantity::vy) / 3, mixed[rule], 1e-12) << rule;
}

// In steps of a microsecond.
TEST(RestitutionRules, LeadWhereAFlightAndAReboundLead) {
  for (int rule = 0; rule < 4; ++rule) {
    const Scenario& family = *Catalog<Scenario>::find("restitution-rules");
    const Scene scene = family.scene(complete(family, {{"rule", static_cast<double>(rule)}}));
    double y = scene.bodies[1].position.y;
    double v = scene.bodies[1].velocity.y;
    constexpr double h = 1e-6;
    for (int i = 0; i < 1000000; ++i) {
      y += h * v;
      if (y < 0.5 && v < 0) v = expected(rule, Quantity::vy);
    }
    EXPECT_NEAR(expected(rule, Quantity::y), y, 1e-5) << rule;
  }
}

// The next rule is .25 of 3 m/s away at least.
TEST(RestitutionRules, StopEveryOtherRule) {
  EXPECT_LT((Of{"restitution-rules", {}, "disc", Quantity::vy}.allows_at_most()), 0.04 * 3 / 100);
}

// Routh's method: the normal impulse grows in small parts, each with friction of the sliding coefficient while the
// point of contact slips, and not at all once it has stopped. The sticking coefficient never enters.
TEST(TwoFrictions, AgreeWithAnImpactOfManySmallPushes) {
  const Scenario& scenario = *Catalog<Scenario>::find("two-frictions");
  for (const double along : {0.5, 1.5, 5.0}) {
    const Parameters p = complete(scenario, {{"along", along}});
    constexpr int parts = 100000;
    constexpr double radius = 0.5;
    const double part = (1 + p.at("restitution")) * p.at("speed") / parts;  // of Jn/m
    double velocity = along;
    double spin = 0;
    for (int i = 0; i < parts; ++i) {
      const double slip = velocity + spin * radius;
      const double friction = std::copysign(std::fmin(p.at("dynamic") * part, std::abs(slip) / 3), slip);
      velocity -= friction;
      spin -= 2 * friction / radius;  // I = m r^2/2
    }
    const auto all = scenario.expectations(p);
    EXPECT_NEAR(*all[0].expected, velocity, 1e-4) << along;
    EXPECT_NEAR(*all[2].expected, spin, 1e-4) << along;
  }
}

}  // namespace
}  // namespace plumb::restitution_rules_test
