#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scenario.h"

namespace plumb::two_frictions_test {
namespace {

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
}  // namespace plumb::two_frictions_test
