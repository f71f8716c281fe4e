#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::bifilar_test {
namespace {

using statement_of::Of;

TEST(Bifilar, SwingsLikeAPointOnOneOfItsRods) {
  for (const double degrees : {5.0, 30.0, 60.0}) {
    const Parameters changes{{"angle", degrees}};
    const Scenario& family = *Catalog<Scenario>::find("bifilar");
    const Scene scene = family.scene(complete(family, changes));
    const double rod = std::get<Distance>(scene.joints[0]).length;
    EXPECT_EQ(rod, std::get<Distance>(scene.joints[1]).length);
    const double start = degrees * std::acos(-1) / 180;
    const auto rate = [&](const std::array<double, 2>& s) {
      return std::array<double, 2>{s[1], -10 / rod * std::sin(s[0])};
    };
    for (const Expectation& one : Of{"bifilar", changes, "bar", Quantity::y}.expectations()) {
      const double angle = integrated(std::array<double, 2>{start, 0}, *one.time, 10000, rate)[0];
      EXPECT_NEAR(*one.expected, -rod * std::cos(angle), 1e-9) << degrees;
    }
  }
}

// The bar itself, hinged at its own distance from one hook, would turn by as much as it swings.
TEST(Bifilar, StopsABarThatHangsFromOneHook) {
  EXPECT_LT((Of{"bifilar", {}, "bar", Quantity::angle}.allows_at_most()), 0.5 / 10);
}

}  // namespace
}  // namespace plumb::bifilar_test
