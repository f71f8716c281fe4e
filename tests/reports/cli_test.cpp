#include "reports/cli.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace plumb {
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

TEST(ParseDt, TakesNumbersAndFractions) {
  EXPECT_EQ(parse_dt("0.01"), 0.01);
  EXPECT_EQ(parse_dt("1/60"), 1.0 / 60);
  EXPECT_EQ(parse_dt("1e-3"), 1e-3);
}

TEST(ParseDt, RefusesWhatIsNoTimeStep) {
  for (const char* text : {"", "0", "-1/60", "1/0", "nan", "inf", "1/60s", "fast", "2", "1/", "/60"}) {
    EXPECT_NE(refusal([&] { parse_dt(text); }), "accepted") << text;
  }
}

TEST(ParseCases, SuggestsTheNearestScenario) {
  EXPECT_THAT(refusal([] { parse_cases("no-such-scenario"); }),
              ::testing::StartsWith("unknown scenario \"no-such-scenario\""));
}

TEST(ParseEntrant, SuggestsTheNearestEngine) {
  EXPECT_THAT(refusal([] { parse_entrant("impulsse"); }), ::testing::StartsWith("unknown engine \"impulsse\""));
}

TEST(ParseCases, TakesAFamilyOneOfItsVariantsOrYourOwn) {
  const auto family = parse_cases("bounce");
  ASSERT_GT(family.size(), 1u);
  EXPECT_EQ(parse_cases("bounce:" + family[1].variant).at(0).parameters, family[1].parameters);
  const Case own = parse_cases("bounce:restitution=1/4").at(0);
  EXPECT_EQ(own.variant, "restitution=1/4");
  EXPECT_EQ(own.parameters.at("restitution"), 0.25);
  ASSERT_NE(own.closed_form, nullptr);
  EXPECT_EQ(own.closed_form->name, own.scenario->closed_form);
}

TEST(ParseCases, RefusesUnknownParametersAndVariants) {
  EXPECT_THAT(refusal([] { parse_cases("bounce:restitutin=1"); }),
              ::testing::HasSubstr("did you mean \"restitution\""));
  EXPECT_THAT(refusal([] { parse_cases("bounce:high"); }), ::testing::StartsWith("bounce: unknown variant \"high\""));
  EXPECT_THAT(refusal([] { parse_cases("bounce:=1"); }), ::testing::HasSubstr("key=value"));
  EXPECT_THAT(refusal([] { parse_cases("bounce:restitution=high"); }), ::testing::HasSubstr("is not a number"));
}

TEST(ParseEntrant, TellsAClosedFormFromAnEngine) {
  EXPECT_THAT(refusal([] { parse_entrant("bounce"); }), ::testing::HasSubstr("is a closed form"));
}

TEST(ParseEntrant, TakesAWordForTheOneOptionThatItIsAChoiceOf) {
  EXPECT_EQ(parse_entrant("impulse:auto").method(), "model=auto");
  EXPECT_EQ(parse_entrant("impulse:float,rk4,substeps=8").method(), "integrator=rk4,substeps=8,precision=float");
  EXPECT_THAT(refusal([] { parse_entrant("impulse:off"); }), ::testing::HasSubstr("rotation=off or "));
  EXPECT_THAT(refusal([] { parse_entrant("impulse:on"); }), ::testing::HasSubstr("may mean"));
  EXPECT_THAT(refusal([] { parse_entrant("impulse:nonsense"); }), ::testing::HasSubstr("key=value"));
}

TEST(DefaultEntrants, BeginWithOursAndHoldNoClosedForm) {
  const auto entrants = default_entrants();
  ASSERT_GT(entrants.size(), 1u);
  EXPECT_EQ(entrants[0].contender->name, "impulse");
  for (const Entrant& entrant : entrants) EXPECT_FALSE(entrant.contender->exact) << entrant.contender->name;
}

TEST(DefaultCases, AreTheCanonicalOnesUnlessAllAreAskedFor) {
  const auto canonical = default_cases(false);
  for (const Case& one : canonical) EXPECT_TRUE(one.scenario->canonical) << one.scenario->name;
  EXPECT_FALSE(canonical.empty());
  EXPECT_GE(default_cases(true).size(), canonical.size());
}

}  // namespace
}  // namespace plumb
