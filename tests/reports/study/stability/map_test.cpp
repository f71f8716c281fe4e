#include "reports/study/stability/map.h"

#include <gmock/gmock.h>

namespace plumb::map_test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Axis, SpacesItsValuesEvenlyWithExactEnds) {
  EXPECT_THAT((Axis{.from = 1, .to = 4}.values(4)), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT((Axis{.from = 4, .to = 1}.values(3)), ElementsAre(4, 2.5, 1)) << "in either direction";
  EXPECT_THAT((Axis{.from = 0.1, .to = 10, .logarithmic = true}.values(3)), ElementsAre(0.1, DoubleNear(1, 1e-12), 10));
}

TEST(Axis, OfIntegersHasEachOnce) {
  const Axis axis{.from = 1, .to = 8, .logarithmic = true, .whole = true};
  EXPECT_THAT(axis.values(7), ElementsAre(1, 2, 3, 4, 6, 8));
}

TEST(Axis, BisectsAnInterval) {
  EXPECT_EQ((Axis{}.between(1, 2)), 1.5);
  EXPECT_DOUBLE_EQ((Axis{.logarithmic = true}.between(1, 4)), 2);
  const Axis whole{.whole = true};
  EXPECT_EQ(whole.between(4, 6), 5);
  EXPECT_EQ(whole.between(4, 5), 4) << "no integer is between";
  EXPECT_EQ(whole.between(5, 4), 5) << "no integer is between";
}

TEST(StabilityMaps, AreKnown) {
  std::vector<std::string> names;
  for (const StabilityMap* map : Catalog<StabilityMap>::all()) names.push_back(map->name);
  EXPECT_THAT(names, ElementsAre("arch", "chain", "mass-ratio", "overhang", "restitution", "slope", "spring", "stack",
                                 "tipping", "tunnelling"));
}

TEST(StabilityMaps, HaveAQuestionAndASourceOfTheirTheory) {
  for (const StabilityMap* map : Catalog<StabilityMap>::all()) {
    EXPECT_TRUE(map->question.ends_with("?")) << map->name;
    ASSERT_FALSE(map->boundaries.empty()) << map->name;
    for (const Boundary& boundary : map->boundaries) {
      EXPECT_EQ(boundary.theory == nullptr, boundary.source.empty()) << map->name;
      EXPECT_EQ(boundary.theory == nullptr, boundary.agreement == 0) << map->name;
      EXPECT_TRUE(map->x.whole || boundary.resolution > 0) << map->name;
      // The width of a bracket must not decide whether it agrees with theory.
      if (boundary.theory) {
        EXPECT_LE(boundary.resolution, boundary.agreement / 2) << map->name;
      }
    }
  }
}

}  // namespace
}  // namespace plumb::map_test
