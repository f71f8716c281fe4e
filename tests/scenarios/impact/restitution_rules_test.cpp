#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace plumb::restitution_rules_test
