#include "reports/run/plan_selection.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

namespace plumb::plan_selection_test {
namespace {

bool holds(const std::vector<Case>& cases, const std::string& scenario) {
  return std::any_of(cases.begin(), cases.end(), [&](const Case& one) { return one.scenario->name == scenario; });
}

TEST(SelectCases, TakesTheCanonicalOnesAndTheExtraOnesByDefault) {
  const auto usual = select_cases({}, false, {"spring:w=4"});
  EXPECT_TRUE(holds(usual, "bounce"));
  EXPECT_TRUE(holds(usual, "spring"));
  const auto named = select_cases({"orbit:round"}, false, {"spring:w=4"});
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named[0].scenario->name, "orbit");
  EXPECT_TRUE(holds(select_cases({}, true, {"spring:w=4"}), "gas"));
}

TEST(SelectPlan, RefusesACaseOrAnEngineThatIsSelectedTwice) {
  EXPECT_THROW(select_plan({"orbit:round", "orbit:round"}, false, {"impulse"}), std::invalid_argument);
  EXPECT_THROW(select_plan({"orbit:round"}, false, {"impulse", "impulse"}), std::invalid_argument);
}

TEST(RequireDistinct, NamesWhatOccursTwice) {
  const std::vector<std::string> names{"a", "b", "a"};
  try {
    require_distinct(names);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"a\""));
  }
}

}  // namespace
}  // namespace plumb::plan_selection_test
