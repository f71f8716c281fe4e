#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "reports/study/job.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"

namespace plumb::model_test {
namespace {

using Json = nlohmann::ordered_json;

Json configuration(const std::vector<std::string>& scenarios, const std::string& tolerance = "1e-4",
                   const std::string& engine = "impulse") {
  return {{"scenarios", scenarios}, {"all", false}, {"engine", engine}, {"dt", "1/60"}, {"tolerance", tolerance}};
}

const Study& study() { return *Catalog<Study>::find("model"); }

std::map<std::string, JobResult> run_all(const Json& configured) {
  std::map<std::string, JobResult> results;
  for (const Job& job : study().plan(configured).jobs) {
    job.prepare();
    results[job.key] = {.key = job.key, .output = job.run()};
  }
  return results;
}

TEST(ModelStudy, PlansEachFeatureDropTheAutomaticModelAndTheLeastModel) {
  const StudyPlan plan = study().plan(configuration({"bounce:e=0.5"}));
  require_distinct_keys(plan.jobs);
  std::vector<std::string> keys;
  for (const Job& job : plan.jobs) {
    keys.push_back(job.key);
    EXPECT_EQ(job.repetition == nullptr, job.alone) << job.key;
  }
  EXPECT_THAT(keys, ::testing::IsSupersetOf({"model|bounce/e=0.5|full", "model|bounce/e=0.5|rotation=off",
                                             "model|bounce/e=0.5|precision=float", "model|bounce/e=0.5|auto",
                                             "model|bounce/e=0.5|least"}));
}

TEST(ModelStudy, FindsThatFreeFlightNeedsNoContacts) {
  const auto results = run_all(configuration({"free-bodies:side=8"}));
  const JobOutput& least = results.at("model|free-bodies/side=8|least").output;
  EXPECT_THAT(least.times.at("line").get<std::string>(), ::testing::HasSubstr("contacts=off"));
  EXPECT_LE(least.times.at("change").get<double>(), 1e-4);
  EXPECT_GT(least.times.at("cheaper").at("median").get<double>(), 2);
  const Json& chosen = results.at("model|free-bodies/side=8|auto").output.values;
  EXPECT_EQ(chosen.at("change"), 0);
  EXPECT_TRUE(chosen.at("within"));
  EXPECT_FALSE(chosen.at("choices").empty());
  EXPECT_FALSE(results.at("model|free-bodies/side=8|rotation=off").output.values.at("within"));
}

TEST(ModelStudy, AcceptsErrorsWithinTheTolerance) {
  const std::string key = "model|spring/w=4|substeps=2";
  EXPECT_FALSE(run_all(configuration({"spring:w=4"})).at(key).output.values.at("within"));
  EXPECT_TRUE(run_all(configuration({"spring:w=4"}, "1e-3")).at(key).output.values.at("within"));
}

TEST(ModelStudy, RefusesEnginesThatCannotLeaveFeaturesOut) {
  const auto refusal = [](const Json& configured) -> std::string {
    try {
      study().plan(configured);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(configuration({"bounce"}, "1e-4", "box2d")), ::testing::HasSubstr("choose impulse"));
  EXPECT_THAT(refusal(configuration({"bounce"}, "1e-4", "impulse:auto")), ::testing::HasSubstr("not a full model"));
  EXPECT_THAT(refusal(configuration({"bounce"}, "0")), ::testing::HasSubstr("above 0"));
}

JobResult fake(const std::string& name, Json values, double time) {
  values.update({{"scenario", "s"}, {"variant", "v"}});
  return {.key = "model|s/v|" + name, .output = {std::move(values), {{"median", time}, {"wide", false}}}};
}

TEST(ModelFindings, GiveCostsRelativeToTheFullModelAndBrokenPromises) {
  const std::vector<JobResult> results{fake("full", {{"role", "full"}}, 2e-3),
                                       fake("a=off", {{"role", "drop"}, {"setting", "a=off"}}, 1e-3),
                                       fake("auto", {{"role", "auto"}, {"within", false}, {"change", 0.5}}, 1e-3)};
  const Findings found = study().plan(configuration({"spring:w=4"})).conclude(results);
  EXPECT_FALSE(found.findings.at("promises")[0].at("kept"));
  EXPECT_EQ(found.timings.at("cases")[0].at("drops")[0].at("ratio"), 0.5);
  EXPECT_TRUE(found.timings.at("cases")[0].at("least").is_null());
  EXPECT_THAT(found.text, ::testing::HasSubstr("as accurate as the full model in 0 of 1 cases"));
}

// A drop of one feature that costs from `low` to `high`, where the full model costs 10 to 11 ms.
std::string told_of_a_cut_search(double low, double high, bool within) {
  const auto timed = [](JobResult result, double from, double to) {
    result.output.times.update({{"low", from}, {"high", to}});
    return result;
  };
  const Json quartiles{{"median", 1}, {"low", 1}, {"high", 1}};
  JobResult least = fake("least", {{"role", "least"}, {"complete", false}}, 0);
  least.output.times = {
      {"line", "impulse"},       {"error", 0}, {"change", 0}, {"cheaper", quartiles}, {"auto_cheaper", quartiles},
      {"dropped", Json::array()}};
  const Json drop{
      {"role", "drop"},   {"setting", "a=off"}, {"feature", "a"}, {"without", "it"}, {"line", "impulse:a=off"},
      {"within", within}, {"error", 0},         {"change", 0},    {"breaks", ""}};
  const std::vector<JobResult> results{timed(fake("full", {{"role", "full"}}, 0.0105), 0.010, 0.011),
                                       timed(fake("a=off", drop, (low + high) / 2), low, high), least};
  return study().plan(configuration({"spring:w=4"})).conclude(results).text;
}

TEST(ModelFindings, NameTheCheapestSingleDropWhereTheSearchHadNoTimeToFindIt) {
  EXPECT_THAT(told_of_a_cut_search(0.005, 0.006, true),
              ::testing::HasSubstr("1.9 times cheaper than the full model: --engine impulse:a=off"));
  EXPECT_THAT(told_of_a_cut_search(0.005, 0.006, false), ::testing::HasSubstr("nothing cheaper was found in time"))
      << "loses something";
  EXPECT_THAT(told_of_a_cut_search(0.009, 0.0105, true), ::testing::HasSubstr("nothing cheaper was found in time"))
      << "noise";
}

// A crashed job has a key but no values.
TEST(ModelFindings, AreFoundEvenIfSomeJobsCrashed) {
  const std::vector<JobResult> results{fake("full", {{"role", "full"}}, 2e-3),
                                       {.key = "model|s/v|a=off", .ending = Ending::crashed},
                                       {.key = "model|s/v|auto", .ending = Ending::timed_out}};
  const Findings found = study().plan(configuration({"spring:w=4"})).conclude(results);
  EXPECT_TRUE(found.timings.at("cases")[0].at("drops").empty());
  EXPECT_FALSE(found.findings.at("promises")[0].at("kept"));
}

}  // namespace
}  // namespace plumb::model_test
