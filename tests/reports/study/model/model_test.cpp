#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "reports/study/job.h"
#include "reports/study/selection.h"
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
