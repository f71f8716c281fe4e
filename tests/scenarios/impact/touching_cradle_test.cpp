#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/random.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::touching_cradle_test {
namespace {

using statement_of::Of;

double bound(int balls, const char* body, Relation relation) {
  const Of of{.scenario = "touching-cradle",
              .changes = {{"balls", static_cast<double>(balls)}, {"speed", 2}},
              .body = body,
              .quantity = Quantity::vx,
              .relation = relation};
  return *of.expectations().front().expected / 2;
}

// Newton's law at every contact, e = 1: only the first approaches, so all others stay together.
TEST(TouchingCradle, HasNewtonsLawAtEveryContactAtOneEnd) {
  for (const int balls : {3, 5, 10}) {
    const double n = balls;
    // v1 + (n - 1) u = 1 and u - v1 = 1.
    const double u = 2 / n;
    EXPECT_NEAR(bound(balls, ("ball " + std::to_string(balls)).c_str(), Relation::at_least), u, 1e-15);
    EXPECT_NEAR(bound(balls, "ball 1", Relation::at_least), u - 1, 1e-15);
  }
}

// Velocities with the sums of v and v^2 at 1, in order: points on a sphere about (1, ..., 1)/n, drawn at random.
TEST(TouchingCradle, BoundsEveryAdmissibleOutcome) {
  Random random(7);
  for (const std::size_t n : {std::size_t{3}, std::size_t{5}}) {
    const std::string last = "ball " + std::to_string(n);
    double nearest = 1;
    for (int draw = 0; draw < 20000; ++draw) {
      std::vector<double> v(n);
      double mean = 0;
      for (double& one : v) mean += (one = random.between(-1, 1)) / static_cast<double>(n);
      double squares = 0;
      for (double& one : v) squares += (one - mean) * (one - mean);
      const double share = 1.0 / static_cast<double>(n);
      for (double& one : v) one = share + (one - mean) * std::sqrt((1 - share) / squares);
      std::sort(v.begin(), v.end());
      EXPECT_GE(v.back(), bound(static_cast<int>(n), last.c_str(), Relation::at_least) - 1e-12);
      EXPECT_LE(v.back(), bound(static_cast<int>(n), last.c_str(), Relation::at_most) + 1e-12);
      EXPECT_GE(v.front(), bound(static_cast<int>(n), "ball 1", Relation::at_least) - 1e-12);
      EXPECT_LE(v.front(), bound(static_cast<int>(n), "ball 1", Relation::at_most) + 1e-12);
      nearest = std::min(nearest, v.back());
    }
    EXPECT_LT(nearest, bound(static_cast<int>(n), last.c_str(), Relation::at_least) + 0.1) << "the bound is sharp";
  }
}

// Without restitution the row moves on together, with 1/3 of the speed in place of 2/3.
TEST(TouchingCradle, StopsARowWithoutRestitution) {
  const Of of{"touching-cradle", {{"balls", 3}}, "ball 3", Quantity::vx, std::nullopt, Relation::at_least};
  for (const Stepping& stated : statement_of::all()) EXPECT_LT(of.allows(stated), 2 * (2. / 3 - 1. / 3) / 5);
}

}  // namespace
}  // namespace plumb::touching_cradle_test
