#include "reports/timing/pace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "reports/run/selection.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using Json = nlohmann::ordered_json;

std::vector<Json> talk(const std::vector<Json>& requests) {
  std::string asked;
  for (const Json& request : requests) asked += request.dump() + "\n";
  std::istringstream in(asked);
  std::ostringstream out;
  pace(in, out);
  std::istringstream said(out.str());
  std::vector<Json> answers;
  for (std::string line; std::getline(said, line);) answers.push_back(Json::parse(line));
  return answers;
}

Json bounce() {
  return {{"scene", write_scene({*parse_case("bounce").scene, {}})}, {"engine", "impulse"}, {"dt", 1.0 / 60}};
}

Json turn(int runs, int steps, int chunk, double patience = 100) {
  return {{"runs", runs}, {"steps", steps}, {"chunk", chunk}, {"patience", patience}};
}

TEST(Pace, GreetsWithItsVersionAndMachine) {
  const auto said = talk({});
  ASSERT_THAT(said, SizeIs(1));
  EXPECT_EQ(said[0]["pace"], pace_version);
  EXPECT_TRUE(said[0]["facts"].contains("processor"));
  EXPECT_TRUE(said[0]["uncounted"].is_string());
}

TEST(Pace, TellsTimesByChunk) {
  const auto said = talk({bounce(), turn(2, 50, 20)});
  ASSERT_THAT(said, SizeIs(3));
  EXPECT_EQ(said[1], Json::object());
  EXPECT_THAT(said[2]["cpu"], SizeIs(3));  // 20, 20 and 10 steps
  EXPECT_THAT(said[2]["wall"], SizeIs(3));
  for (const double time : said[2]["cpu"]) EXPECT_GT(time, 0);
  EXPECT_EQ(said[2]["count"].is_null(), !said[0]["uncounted"].get<std::string>().empty());
}

TEST(Pace, EndsARunThatTakesLongerThanItsPatience) {
  EXPECT_THAT(talk({bounce(), turn(3, 50, 10, 1e-12)})[2]["cpu"], SizeIs(1));
}

TEST(Pace, SaysWhatItCannotDoAndGoesOn) {
  Json unknown = bounce();
  unknown["engine"] = "impuls";
  const auto said = talk({turn(1, 1, 1), unknown, {{"scene", "{"}}, turn(0, 1, 1), bounce(), turn(1, 5, 5)});
  ASSERT_THAT(said, SizeIs(7));
  EXPECT_THAT(said[1]["refused"].get<std::string>(), HasSubstr("nothing to step"));
  EXPECT_THAT(said[2]["refused"].get<std::string>(), HasSubstr("impulse"));
  EXPECT_TRUE(said[3].contains("refused"));
  EXPECT_TRUE(said[4].contains("refused"));
  EXPECT_EQ(said[5], Json::object());
  EXPECT_THAT(said[6]["cpu"], SizeIs(1));
}

}  // namespace
}  // namespace plumb
