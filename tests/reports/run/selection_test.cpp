#include "reports/run/selection.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "reports/run/scene_file.h"

namespace plumb::selection_test {
namespace {

template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ParseDt, AcceptsNumbersAndFractions) {
  EXPECT_EQ(parse_dt("0.01"), 0.01);
  EXPECT_EQ(parse_dt("1/60"), 1.0 / 60);
  EXPECT_EQ(parse_dt("1e-3"), 1e-3);
}

TEST(ParseDt, RefusesAnythingThatIsNotATimeStep) {
  for (const char* text : {"", "0", "-1/60", "1/0", "nan", "inf", "1/60s", "fast", "2", "1/", "/60"}) {
    EXPECT_NE(refusal([&] { parse_dt(text); }), "accepted") << text;
  }
}

TEST(ParseCases, SuggestsTheNearestScenario) {
  EXPECT_THAT(refusal([] { parse_cases("no-such-scenario"); }),
              ::testing::StartsWith("unknown scenario \"no-such-scenario\""));
}

TEST(ParseEngine, SuggestsTheNearestEngine) {
  EXPECT_THAT(refusal([] { parse_engine("impulsse"); }), ::testing::StartsWith("unknown engine \"impulsse\""));
}

TEST(ParseCases, AcceptsAScenarioAVariantOrYourOwn) {
  const auto family = parse_cases("bounce");
  ASSERT_GT(family.size(), 1u);
  EXPECT_EQ(parse_cases("bounce:" + family[1].variant).at(0).parameters, family[1].parameters);
  const Case own = parse_cases("bounce:restitution=1/4").at(0);
  EXPECT_EQ(own.variant, "restitution=1/4");
  EXPECT_EQ(own.parameters.at("restitution"), 0.25);
  ASSERT_NE(own.closed_form, nullptr);
  EXPECT_EQ(own.closed_form->name, own.scenario->closed_form);
}

TEST(ParseCases, AcceptsReportedCases) {
  const auto all = parse_cases("tracker");
  ASSERT_EQ(all.size(), reported_cases().size());
  const auto one = parse_cases("tracker:" + all[1].scenario->name);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].scenario->name, all[1].scenario->name);
  EXPECT_THAT(refusal([] { parse_cases("tracker:rapier-974-rebounds"); }),
              ::testing::HasSubstr("did you mean \"rapier-974-rebound\""));
}

TEST(ParseCases, RefusesUnknownParametersAndVariants) {
  EXPECT_THAT(refusal([] { parse_cases("bounce:restitutin=1"); }),
              ::testing::HasSubstr("did you mean \"restitution\""));
  EXPECT_THAT(refusal([] { parse_cases("bounce:high"); }), ::testing::StartsWith("bounce: unknown variant \"high\""));
  EXPECT_THAT(refusal([] { parse_cases("bounce:=1"); }), ::testing::HasSubstr("key=value"));
  EXPECT_THAT(refusal([] { parse_cases("bounce:restitution=high"); }), ::testing::HasSubstr("is not a number"));
}

TEST(ParseEngine, RefusesAClosedForm) {
  EXPECT_THAT(refusal([] { parse_engine("bounce"); }), ::testing::HasSubstr("is a closed form"));
}

TEST(ParseEngine, AcceptsAWordThatIsAChoiceOfOneOption) {
  EXPECT_EQ(parse_engine("impulse:auto").method(), "model=auto");
  EXPECT_EQ(parse_engine("impulse:float,rk4,substeps=8").method(), "integrator=rk4,substeps=8,precision=float");
  EXPECT_THAT(refusal([] { parse_engine("impulse:off"); }), ::testing::HasSubstr("rotation=off or "));
  EXPECT_THAT(refusal([] { parse_engine("impulse:on"); }), ::testing::HasSubstr("may mean"));
  EXPECT_THAT(refusal([] { parse_engine("impulse:nonsense"); }), ::testing::HasSubstr("key=value"));
}

TEST(DefaultEngines, StartWithOursAndContainNoClosedForm) {
  const auto configs = default_engines();
  ASSERT_GT(configs.size(), 1u);
  EXPECT_EQ(configs[0].engine->name, "impulse");
  for (const EngineConfig& config : configs) EXPECT_FALSE(config.engine->exact) << config.engine->name;
}

TEST(DefaultCases, AreTheCanonicalOnesByDefault) {
  const auto canonical = default_cases(false);
  for (const Case& one : canonical) EXPECT_TRUE(one.scenario->canonical) << one.scenario->name;
  EXPECT_FALSE(canonical.empty());
  EXPECT_GE(default_cases(true).size(), canonical.size());
}

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
}  // namespace plumb::selection_test
