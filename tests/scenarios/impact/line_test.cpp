#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/random.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::line_test {
namespace {

using statement_of::Of;

// Equal masses swap velocities: after three impacts the heavy block flies off as fast as it came and the light one
// rests.
TEST(PiBilliard, CountsTheImpactsOfEqualBlocks) {
  const Of heavy{"pi-billiard", {{"digits", 0}}, "heavy", Quantity::vx};
  const Of light{"pi-billiard", {{"digits", 0}}, "light", Quantity::vx};
  EXPECT_NEAR(*heavy.expectations().front().expected, 2, 1e-12);
  EXPECT_NEAR(*light.expectations().front().expected, 0, 1e-12);
  // After two impacts they have 0 and 2. What was once allowed: a heavy block that has lost a fifth of its energy.
  EXPECT_LT(heavy.allows_at_most(), 2 - 1.797);
  EXPECT_LT(heavy.allows_at_most(), 2 - 2 * std::sqrt(0.99));
}

// One impact more or less turns the state by 2 q or changes the light block's sign.
TEST(PiBilliard, TellsThirtyOneImpactsFromThirtyIfTheyComeOneByOne) {
  const Stepping stated = statement_of::accurate();
  const Of heavy{"pi-billiard", {{"digits", 1}}, "heavy", Quantity::vx};
  const Of light{"pi-billiard", {{"digits", 1}}, "light", Quantity::vx};
  EXPECT_LT(heavy.allows(stated), 1e-6);
  EXPECT_LT(light.allows(stated), 1e-6);
  EXPECT_GT(std::abs(*light.expectations().front().expected), 0.1);
}

TEST(PiBilliard, AllowsAMethodThatMayMissACountNoMoreThanTheLastSector) {
  const Of heavy{"pi-billiard", {{"digits", 1}}, "heavy", Quantity::vx};
  EXPECT_LT(heavy.allows(statement_of::skinned()), 0.01);
}

// e = .9 instead of 1: 4 m/s of approach, of which three quarters change the left disc.
TEST(HeadOn, StopsATenthLessRestitution) {
  EXPECT_LT((Of{"head-on", {{"restitution", 1}}, "left", Quantity::vx}.allows_at_most()), 0.1 * 4 * 0.75 / 100);
}

// Discs that stay where they meet would be off by twice this.
TEST(HeadOn, StopsDiscsThatPassThroughEachOther) {
  EXPECT_LT((Of{"head-on", {}, "left", Quantity::x}.allows_at_most()), 1.5 * 4 * 0.75 / 10);
}

constexpr double cos45 = 0.7071067811865476;

// mu (1+e) vn along the wall, and 2/r times that of spin.
TEST(ObliqueDisc, StopsAFrictionlessOne) {
  const double slips = 0.1 * 1.6 * 6 * cos45;
  EXPECT_LT((Of{"oblique-disc", {}, "disc", Quantity::vx}.allows_at_most()), slips / 100);
  EXPECT_LT((Of{"oblique-disc", {}, "disc", Quantity::angular_velocity}.allows_at_most()), 4 * slips / 4);
  const double grips = (6 * cos45 + 1) / 3;
  EXPECT_LT((Of{"oblique-disc", {{"friction", 0.9}}, "disc", Quantity::vx}.allows_at_most()), grips / 4);
}

// A hoop keeps half of the slip instead of a third: its spin changes by half as much per impulse.
TEST(ObliqueDisc, StopsAHoop) {
  EXPECT_LT((Of{"oblique-disc", {}, "disc", Quantity::angular_velocity}.allows_at_most()),
            2 * 0.1 * 1.6 * 6 * cos45 / 2);
  const double slip = 6 * cos45 + 1;
  EXPECT_LT((Of{"oblique-disc", {{"friction", 0.9}}, "disc", Quantity::vx}.allows_at_most()), slip * (1. / 2 - 1. / 3));
}

// The box has the spin 6 c J/m; with the inertia of a disc of its size, m/8, it would have 8 c J/m.
TEST(CornerImpact, StopsABoxOfWrongInertia) {
  EXPECT_LT((Of{"corner-impact", {}, "box", Quantity::angular_velocity}.allows_at_most()), 3.29 * (1. / 3) / 4);
  EXPECT_LT((Of{"corner-impact", {}, "box", Quantity::vy}.allows_at_most()), 0.05 * 2);
}

TEST(CornerImpact, DoesNotTakeASlopForALeverArm) {
  Stepping stated = statement_of::positions_first();
  const Of spin{"corner-impact", {}, "box", Quantity::angular_velocity};
  const double before = spin.allows(stated);
  stated.slop = 0.1;
  EXPECT_EQ(spin.allows(stated), before);
}

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
}  // namespace plumb::line_test
