#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <sstream>

#include "../../../reference/programs/faults.h"
#include "../study_files.h"
#include "reports/study/job.h"
#include "reports/study/speed/work_precision.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"

namespace plumb::speed_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Studies, AreKnown) {
  std::vector<std::string> names;
  for (const Study* study : Catalog<Study>::all()) names.push_back(study->name);
  EXPECT_THAT(names, ::testing::IsSupersetOf({"speed"}));
}

// The results of a small speed study, without times.
std::vector<JobResult> results_of(const Json& configuration) {
  const StudyPlan plan = Catalog<Study>::find("speed")->plan(configuration);
  std::vector<JobResult> results;
  for (const Job& job : plan.jobs) {
    if (job.prepare) job.prepare();
    results.push_back({.key = job.key, .output = job.run()});
  }
  return results;
}

Json configuration(const std::vector<std::string>& scenarios, const std::vector<std::string>& engines,
                   const std::vector<std::string>& steps = {"1/30", "1/60", "1/120", "1/240", "1/480", "1/960"}) {
  return {{"scenarios", scenarios}, {"all", false}, {"engines", engines}, {"dt", steps}};
}

std::vector<Json> orders_of(const Json& configured) {
  const Findings found = Catalog<Study>::find("speed")->plan(configured).conclude(results_of(configured));
  std::vector<Json> rows;
  for (const Json& row : found.findings.at("orders")) rows.push_back(row);
  return rows;
}

// Free fall is exact for second and higher orders. On a slope contacts lower the order of all integrators but RK4,
// where two errors cancel to second order; our default method solves for friction together with the load, exactly.
TEST(SpeedStudy, MeasuresTheOrderOfEachOfOurIntegrators) {
  const std::vector<std::string> engines{
      "impulse:solver=exact,integrator=explicit-euler", "impulse:solver=exact,integrator=symplectic-euler",
      "impulse:solver=exact,integrator=velocity-verlet", "impulse:solver=exact,integrator=rk4", "impulse:substeps=4"};
  const std::map<std::string, std::vector<double>> theory{
      {"spring", {1, 1, 2, 4, 2}}, {"slope", {1, 1, 1, 2, 0}}, {"spinning-obb", {1, 1, 0, 0, 0}}};
  for (const auto& [scenario, of] : theory) {
    const std::string variant = scenario == "spring" ? "w=4" : scenario == "slope" ? "steep" : "free-fall";
    std::map<std::string, Json> rows;
    for (const Json& row : orders_of(configuration({scenario + ":" + variant}, engines))) {
      if (row.at("standard")) rows[row.at("engine")] = row;
    }
    ASSERT_EQ(rows.size(), engines.size()) << scenario;
    for (std::size_t i = 0; i < engines.size(); ++i) {
      const std::string name = i == 1 ? "impulse:solver=exact" : i == 4 ? "impulse" : engines[i];
      const Json& row = rows.at(name);
      EXPECT_EQ(row.at("finding"), of[i] == 0 ? "exact" : "as stated") << row.dump();
      if (of[i] == 0) continue;
      EXPECT_EQ(row.at("stated"), of[i]) << row.dump();
      EXPECT_NEAR(row.at("order").get<double>(), of[i], 0.2) << row.dump();
    }
  }
}

TEST(SpeedStudy, AveragesOverPhasesOfAStepIfThereAreImpacts) {
  const auto results = results_of(configuration({"bounce:e=0.8"}, {"impulse:solver=article,iterations=10"}, {"1/60"}));
  const Json& values = results.front().output.values;
  EXPECT_EQ(values.at("phases"), 8);
  EXPECT_LT(values.at("error_least"), values.at("error"));
  EXPECT_LT(values.at("error"), values.at("error_largest"));
}

TEST(SpeedStudy, UsesAConvergedReferenceIfThereIsNoClosedForm) {
  const auto results = results_of(configuration({"pyramid:base=2,duration=0.5"}, {"impulse", "box2d"}, {"1/60"}));
  const Json& values = results.front().output.values;
  EXPECT_EQ(values.at("truth"), "converged");
  EXPECT_GT(values.at("truth_error"), 0);
  EXPECT_LT(values.at("truth_error"), 1e-3);
  EXPECT_EQ(values.at("status"), "ok");
}

TEST(SpeedStudy, SaysWhatIsNotSupported) {
  const auto results = results_of(configuration({"hanging-chain"}, {"impulse:solver=exact"}, {"1/60"}));
  for (const JobResult& result : results) {
    EXPECT_NE(result.output.values.at("status"), "ok") << result.key;
    EXPECT_FALSE(result.output.values.at("why").get<std::string>().empty());
    EXPECT_FALSE(result.output.values.contains("error"));
  }
}

TEST(SpeedStudy, TimesOnlyRunsThatReachTheEnd) {
  for (const auto& [engine, timed] :
       {std::pair("impulse:solver=exact", false), std::pair("impulse:solver=xpbd", true)}) {
    const StudyPlan plan = Catalog<Study>::find("speed")->plan(configuration({"hanging-chain"}, {engine}, {"1/60"}));
    const Job& job = plan.jobs.front();
    job.prepare();
    const bool ran = job.run().values.contains("error");
    EXPECT_EQ(std::isfinite(job.repetition()), ran && timed) << engine;
  }
}

TEST(SpeedStudy, PlansEveryParameterStepOfEachMethodOnce) {
  const StudyPlan plan = Catalog<Study>::find("speed")->plan(configuration({"bounce:e=0.5"}, {}));
  std::map<std::string, int> keys;
  for (const Job& job : plan.jobs) EXPECT_EQ(++keys[job.key], 1) << job.key;
  for (const char* key :
       {"speed|bounce/e=0.5|impulse|substeps=8|dt=1/120", "speed|bounce/e=0.5|box2d|velocity=16|dt=1/960",
        "speed|bounce/e=0.5|impulse:solver=exact,integrator=rk4|dt=1/30",
        "speed|bounce/e=0.5|impulse:solver=xpbd|substeps=1|dt=1/60"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

// The result of a run. `time`: s per simulated second; `error`: m.
JobResult fake(const std::string& engine, double dt, double time, double error) {
  const std::string step = std::to_string(dt);
  return {.key = "speed|s/v|" + engine + "|dt=" + step,
          .output = {{{"scenario", "s"},
                      {"variant", "v"},
                      {"engine", engine},
                      {"execution", engine == "half" ? "WebAssembly" : "native"},
                      {"method", ""},
                      {"option", ""},
                      {"setting", ""},
                      {"standard", true},
                      {"dt", dt},
                      {"status", "ok"},
                      {"order", 0},
                      {"truth_error", 0.0},
                      {"scale", 2.0},
                      {"round_off", 0.0},
                      {"error", error}},
                     {{"median", time}, {"wide", false}}}};
}

Json row_of(const Json& target, const std::string& engine) {
  for (const Json& row : target.at("engines")) {
    if (row.at("engine") == engine) return row;
  }
  return nullptr;
}

// Time doubles where the error halves: on such a front every rule of interpolation reads the same.
Findings three_engines() {
  std::vector<JobResult> results;
  for (const double n : {10.0, 100.0, 1000.0, 10000.0}) {
    results.push_back(fake("box2d", 1 / n, 1e-3 * n, 1 / n));
    results.push_back(fake("half", 1 / n, 0.5e-3 * n, 1 / n));
    results.push_back(fake("coarse", 1 / n, 1e-5 * n, 1e2 / n));
  }
  return Catalog<Study>::find("speed")->plan(configuration({"spring"}, {"box2d"})).conclude(results);
}

TEST(SpeedFindings, CompareTimesToFixedErrors) {
  const Json timings = three_engines().timings;
  const Json& targets = timings.at("targets");
  ASSERT_EQ(targets.size(), 6u);
  EXPECT_EQ(targets[1].at("error"), 1e-3);
  EXPECT_NEAR(row_of(targets[1], "half").at("median").get<double>(), 1, 1e-12);
  EXPECT_NEAR(row_of(targets[1], "box2d").at("median").get<double>(), 2, 1e-12);
  EXPECT_EQ(row_of(targets[1], "half").at("fastest"), 1);
  const Json& first = timings.at("cases").front();
  EXPECT_EQ(first.at("front").size(), 6u) << "two of the coarse engine, then all of the faster one";
  EXPECT_NEAR(first.at("engines")[0].at("time_for_error")[1].at("value").get<double>(), 1, 1e-12);
  EXPECT_NEAR(first.at("engines")[0].at("time_for_scale")[1].at("value").get<double>(), 0.1 / 2, 1e-12)
      << "1 % of a scale of 2 m is 2 cm";
}

TEST(SpeedFindings, SayThatAMethodNeverGetsThereInsteadOfCountingWhatItReaches) {
  const Json timings = three_engines().timings;
  EXPECT_TRUE(row_of(timings.at("targets")[1], "coarse").at("median").is_null()) << "its best run is at 1 cm";
  EXPECT_EQ(row_of(timings.at("targets")[1], "coarse").at("reached"), 0);
  EXPECT_EQ(row_of(timings.at("targets")[0], "coarse").at("reached"), 1);
}

TEST(SpeedFindings, NameTheFastestToAMillimetreFirst) {
  EXPECT_THAT(
      three_engines().text,
      ::testing::StartsWith("s, v: half (WebAssembly) is the fastest to 1 mm: 500 ms for a simulated second; next is "
                            "box2d, 2 times that, but the two\nrun differently: no factor of method alone. Never that "
                            "accurate: coarse.\n"));
}

TEST(SpeedFindings, FitTheWidthByLeavingOutWhatTheHeadlineDoesNotName) {
  const std::string text = times_text(three_engines().timings, 44);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 44U) << line;
  EXPECT_THAT(text, ::testing::HasSubstr("\n  method                1 cm    1 mm  0.1 mm\n"));
  EXPECT_THAT(times_text(three_engines().timings, 30), ::testing::HasSubstr("\n  method                1 mm\n"));
}

TEST(SpeedFindings, TellTimesApartByHowCodeRuns) {
  const Findings found = three_engines();
  EXPECT_EQ(row_of(found.timings.at("targets")[1], "half").at("execution"), "WebAssembly");
  EXPECT_THAT(found.text, ::testing::HasSubstr("\n  half (WebAssembly) "));
  EXPECT_THAT(found.text, ::testing::HasSubstr("factors between them are not of the methods alone"));
}

TEST(SpeedStudy, ShowsAnEngineThatFailsEverywhere) {
  for (const char* fault : {"crash", "crashes-when-asked-how"}) {
    const Json asked =
        configuration({"spring"}, {"impulse:solver=xpbd", faulty_program(PLUMB_SOURCE_DIR, fault)}, {"1/30", "1/60"});
    const auto results = results_of(asked);
    const Findings found = Catalog<Study>::find("speed")->plan(asked).conclude(results);
    EXPECT_THAT(found.text, ::testing::HasSubstr(" failed in 12 of 12 jobs, first in spring/")) << fault;
    EXPECT_THAT(found.text, ::testing::HasSubstr("ended by signal 11")) << fault;
    EXPECT_EQ(found.findings.at("failures")[0].at("failed"), 12) << fault;
  }
}

TEST(SpeedStudy, TakesTheLadderOfAProgramFromItsOptions) {
  const Json asked = configuration({"bounce:e=0.5"}, {faulty_program(PLUMB_SOURCE_DIR, "none")}, {"1/60"});
  std::vector<std::string> keys;
  for (const Job& job : Catalog<Study>::find("speed")->plan(asked).jobs) keys.push_back(job.key);
  EXPECT_THAT(keys, ::testing::ElementsAre(::testing::HasSubstr("|knob=0|"), ::testing::HasSubstr("|knob=1|"),
                                           ::testing::HasSubstr("|knob=2|")));
}

}  // namespace
}  // namespace plumb::speed_test
