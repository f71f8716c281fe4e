#include "reports/study/asked_cases.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace plumb {
namespace {

bool holds(const std::vector<Case>& cases, const std::string& scenario) {
  return std::any_of(cases.begin(), cases.end(), [&](const Case& one) { return one.scenario->name == scenario; });
}

TEST(CasesAsked, AreTheCanonicalOnesAndSomeBesidesUnlessAskedOtherwise) {
  const auto usual = cases_asked({}, false, {"spring:w=4"});
  EXPECT_TRUE(holds(usual, "bounce"));
  EXPECT_TRUE(holds(usual, "spring"));
  const auto asked = cases_asked({"orbit:round"}, false, {"spring:w=4"});
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].scenario->name, "orbit");
  EXPECT_TRUE(holds(cases_asked({}, true, {"spring:w=4"}), "gas"));
}

TEST(CasesAsked, AreToldApartByTheirScenes) {
  const auto a = cases_asked({"spring:w=4"}, false, {});
  EXPECT_EQ(hash_of(a), hash_of(cases_asked({"spring:w=4"}, false, {})));
  EXPECT_NE(hash_of(a), hash_of(cases_asked({"spring:w=15"}, false, {})));
}

TEST(MustDiffer, NamesAPointThatIsThereTwice) {
  const std::vector<Point> points{{.key = "a"}, {.key = "b"}, {.key = "a"}};
  try {
    must_differ(points);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"a\""));
  }
}

}  // namespace
}  // namespace plumb
