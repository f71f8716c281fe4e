#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "reports/study/asked_cases.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json configuration(const std::vector<std::string>& scenarios, const std::string& tolerance = "1e-4",
                   const std::string& engine = "impulse") {
  return {{"scenarios", scenarios}, {"all", false}, {"engine", engine}, {"dt", "1/60"}, {"tolerance", tolerance}};
}

const Study& study() { return *Catalog<Study>::find("model"); }

std::map<std::string, PointResult> run_all(const Json& asked) {
  std::map<std::string, PointResult> results;
  for (const Point& point : study().plan(asked).points) {
    point.prepare();
    results[point.key] = {.key = point.key, .row = point.run()};
  }
  return results;
}

TEST(ModelStudy, PlansEachFeatureAloneTheEnginesChoiceAndTheLeastModel) {
  const StudyPlan plan = study().plan(configuration({"bounce:e=0.5"}));
  must_differ(plan.points);
  std::vector<std::string> keys;
  for (const Point& point : plan.points) {
    keys.push_back(point.key);
    EXPECT_EQ(point.turn == nullptr, point.alone) << point.key;
  }
  EXPECT_THAT(keys, ::testing::IsSupersetOf({"model|bounce/e=0.5|full", "model|bounce/e=0.5|rotation=off",
                                             "model|bounce/e=0.5|precision=float", "model|bounce/e=0.5|auto",
                                             "model|bounce/e=0.5|least"}));
}

TEST(ModelStudy, FindsByItselfThatFreeFlightNeedsNoContacts) {
  const auto results = run_all(configuration({"free-bodies:side=8"}));
  const Row& least = results.at("model|free-bodies/side=8|least").row;
  EXPECT_THAT(least.times.at("line").get<std::string>(), ::testing::HasSubstr("contacts=off"));
  EXPECT_LE(least.times.at("change").get<double>(), 1e-4);
  EXPECT_GT(least.times.at("cheaper").at("median").get<double>(), 2);
  const Json& chosen = results.at("model|free-bodies/side=8|auto").row.values;
  EXPECT_EQ(chosen.at("change"), 0);
  EXPECT_TRUE(chosen.at("within"));
  EXPECT_FALSE(chosen.at("choices").empty());
  EXPECT_FALSE(results.at("model|free-bodies/side=8|rotation=off").row.values.at("within"));
}

TEST(ModelStudy, AllowsWhatTheToleranceAllows) {
  const std::string key = "model|spring/w=4|substeps=2";
  EXPECT_FALSE(run_all(configuration({"spring:w=4"})).at(key).row.values.at("within"));
  EXPECT_TRUE(run_all(configuration({"spring:w=4"}, "1e-3")).at(key).row.values.at("within"));
}

TEST(ModelStudy, RefusesWhatCannotLeaveFeaturesOut) {
  const auto refusal = [](const Json& asked) -> std::string {
    try {
      study().plan(asked);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(configuration({"bounce"}, "1e-4", "box2d")), ::testing::HasSubstr("ask about impulse"));
  EXPECT_THAT(refusal(configuration({"bounce"}, "1e-4", "impulse:auto")), ::testing::HasSubstr("no full model"));
  EXPECT_THAT(refusal(configuration({"bounce"}, "0")), ::testing::HasSubstr("above 0"));
}

PointResult fake(const std::string& name, Json values, double time) {
  values.update({{"scenario", "s"}, {"variant", "v"}});
  return {.key = "model|s/v|" + name, .row = {std::move(values), {{"median", time}, {"wide", false}}}};
}

TEST(ModelFindings, TellCostsAsSharesOfTheFullModelsAndBrokenPromises) {
  const std::vector<PointResult> results{fake("full", {{"role", "full"}}, 2e-3),
                                         fake("a=off", {{"role", "drop"}, {"setting", "a=off"}}, 1e-3),
                                         fake("auto", {{"role", "auto"}, {"within", false}, {"change", 0.5}}, 1e-3)};
  const Findings found = study().plan(configuration({"spring:w=4"})).conclude(results);
  EXPECT_FALSE(found.findings.at("promises")[0].at("kept"));
  EXPECT_EQ(found.timings.at("cases")[0].at("drops")[0].at("ratio"), 0.5);
  EXPECT_TRUE(found.timings.at("cases")[0].at("least").is_null());
  EXPECT_THAT(found.summary, ::testing::HasSubstr("within the tolerance in 0 of 1 cases"));
}

// What a crash leaves is a key and no values.
TEST(ModelFindings, AreFoundThoughSomePointsCrashed) {
  const std::vector<PointResult> results{fake("full", {{"role", "full"}}, 2e-3),
                                         {.key = "model|s/v|a=off", .ending = Ending::crashed},
                                         {.key = "model|s/v|auto", .ending = Ending::timed_out}};
  const Findings found = study().plan(configuration({"spring:w=4"})).conclude(results);
  EXPECT_TRUE(found.timings.at("cases")[0].at("drops").empty());
  EXPECT_FALSE(found.findings.at("promises")[0].at("kept"));
}

}  // namespace
}  // namespace plumb
