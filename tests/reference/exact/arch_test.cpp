#include "reference/exact/statics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb::arch_test {
namespace {

constexpr double rough = 10;  // friction at which nothing slides

// A semicircle of n stones with a mean radius of 1 m, times a scale.
Arch semicircle(int n, double thickness, double friction, double scale = 1) {
  const auto at = [&](double r, int cut) {
    const double angle = std::numbers::pi * (1 - static_cast<double>(cut) / n);
    return Vec{scale * r * std::cos(angle), scale * r * std::sin(angle)};
  };
  const double inner = 1 - thickness / 2;
  const double outer = 1 + thickness / 2;
  std::vector<BedJoint> beds;
  std::vector<Arch::Stone> stones;
  for (int k = 0; k <= n; ++k) {
    const Vec out = (1 / scale) * at(1, k);
    beds.push_back({at(inner, k), at(outer, k), {out.y, -out.x}});
    if (k == n) break;
    const Body stone{
        .shapes = {{.geometry = Polygon{{at(inner, k), at(outer, k), at(outer, k + 1), at(inner, k + 1)}}}}};
    stones.push_back({mass_of(stone).center, {0, -10 * mass_of(stone).mass}});
  }
  return {beds, stones, friction};
}

// The smallest thickness that stands, to 1e-5.
double limit(int n) {
  double falls = 0.02;
  double stands = 0.3;
  while (stands - falls > 1e-5) {
    const double middle = (falls + stands) / 2;
    (semicircle(n, middle, rough).stands() ? stands : falls) = middle;
  }
  return stands;
}

// Milankovitch's 0.1075 is for hinges anywhere. Doubling the number of stones keeps all joints and adds more, so that
// it can only lower the stability.
TEST(Arch, OfManyStonesStandsFromMilankovitchsThickness) {
  EXPECT_NEAR(limit(40), 0.1075, 1e-4);
  EXPECT_LE(limit(10), limit(20));
  EXPECT_LE(limit(20), limit(40));
}

TEST(Arch, OfTwentyStonesHasTheLimitThatTheScenarioUses) { EXPECT_NEAR(limit(20), 0.1074, 1e-4); }

TEST(Arch, IsIndependentOfItsScale) {
  for (const double scale : {1e-3, 1e3}) {
    EXPECT_TRUE(semicircle(16, 0.11, rough, scale).stands());
    EXPECT_FALSE(semicircle(16, 0.10, rough, scale).stands());
  }
}

// A semicircle of any thickness needs a friction of at least 0.31 not to slide.
TEST(Arch, NeedsFriction) {
  EXPECT_TRUE(semicircle(12, 0.12, 0.4).stands());
  EXPECT_FALSE(semicircle(12, 0.12, 0.3).stands());
}

// Two stones that lean on each other at the top, with their feet flat on the ground. The slope of the line of thrust
// from foot to ridge follows from moments: H = W x/h for the weight W of one stone at x before the ridge.
TEST(Arch, OfTwoStonesNeedsTheThrustThatMomentsGive) {
  const auto gable = [](double friction) {
    return Arch({{{-2, 0}, {-1.9, 0}, {0, 1}}, {{0, 2}, {0, 2.1}, {1, 0}}, {{1.9, 0}, {2, 0}, {0, -1}}},
                {{{-1, 1}, {0, -10}}, {{1, 1}, {0, -10}}}, friction);
  };
  // The friction needed for a thrust from the outer edge of the foot to the upper end of the ridge.
  const double least = (2 - 1) / 2.1;
  EXPECT_TRUE(gable(least + 1e-6).stands());
  // A thrust from the inner edge of the foot, at 1.9, is steeper and needs only 0.9/2.1.
  const double feet = 0.9 / 2.1;
  EXPECT_TRUE(gable(feet + 1e-6).stands());
  EXPECT_FALSE(gable(feet - 1e-6).stands());
}

TEST(ArchScene, IsRefusedIfItFallsOrHasAGap) {
  const Scenario& family = *Catalog<Scenario>::find("arch");
  const Engine& arch = *Catalog<Engine>::find("arch");
  Scene scene = family.scene(complete(family, {}));
  EXPECT_EQ(arch.unsupported(scene, {}), "");
  EXPECT_THAT(arch.unsupported(family.scene(complete(family, {{"thickness", 0.107}})), {}),
              testing::HasSubstr("no line of thrust"));
  scene.bodies[7].position.x += 1e-3;
  EXPECT_THAT(arch.unsupported(scene, {}), testing::HasSubstr("share a side"));
}

}  // namespace
}  // namespace plumb::arch_test
