#include "reports/history/json_place.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace plumb {
namespace {

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(JsonPlace, NamesTheDocumentAndThePlace) {
  const auto json = parse_json(R"({"runs": [{"dt": "soon"}, 3]})", "mine.json");
  const JsonPlace place(json, "mine.json");
  const auto runs = place.at("runs").items();
  EXPECT_EQ(refusal([&] { runs[0].at("dt").number(); }), "mine.json: runs[0].dt: expected a number, found \"soon\"");
  EXPECT_EQ(refusal([&] { runs[0].at("engine").text(); }), "mine.json: runs[0].engine is missing");
  EXPECT_EQ(refusal([&] { runs[1].at("dt"); }), "mine.json: runs[1]: expected an object, found 3");
  EXPECT_EQ(refusal([&] { place.items(); }).substr(0, 34), "mine.json: expected a list, found ");
}

TEST(JsonPlace, TakesNullForANumberThatIsNotFiniteOnlyWhereItMayBe) {
  const auto json = parse_json(R"({"value": null, "many": -1})", "mine.json");
  const JsonPlace place(json, "mine.json");
  EXPECT_TRUE(std::isnan(place.at("value").number_or_null()));
  EXPECT_THROW(place.at("value").number(), std::invalid_argument);
  EXPECT_THROW(place.at("many").count(), std::invalid_argument);
}

TEST(JsonPlace, SaysWhereATextIsNoJson) {
  EXPECT_THAT(refusal([] { parse_json("{\"a\": ", "mine.json"); }), ::testing::HasSubstr("mine.json: is not JSON"));
}

}  // namespace
}  // namespace plumb
