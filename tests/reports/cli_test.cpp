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

}  // namespace
}  // namespace plumb
