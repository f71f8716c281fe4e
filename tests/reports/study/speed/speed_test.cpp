#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "../study_files.h"
#include "reports/study/runner.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

TEST(Studies, AreThese) {
  std::vector<std::string> names;
  for (const Study* study : Catalog<Study>::all()) names.push_back(study->name);
  EXPECT_THAT(names, ::testing::IsSupersetOf({"speed"}));
}

// The results of a small speed study, without its clock.
std::vector<PointResult> results_of(const Json& configuration) {
  const StudyPlan plan = Catalog<Study>::find("speed")->plan(configuration);
  std::vector<PointResult> results;
  for (const Point& point : plan.points) {
    if (point.prepare) point.prepare();
    results.push_back({.key = point.key, .row = point.run()});
  }
  return results;
}

Json configuration(const std::vector<std::string>& scenarios, const std::vector<std::string>& engines,
                   const std::vector<std::string>& steps = {"1/30", "1/60", "1/120", "1/240", "1/480", "1/960"}) {
  return {{"scenarios", scenarios}, {"all", false}, {"engines", engines}, {"dt", steps}};
}

std::vector<Json> orders_of(const Json& asked) {
  const Findings found = Catalog<Study>::find("speed")->plan(asked).conclude(results_of(asked));
  std::vector<Json> rows;
  for (const Json& row : found.findings.at("orders")) rows.push_back(row);
  return rows;
}

// Free fall is exact for second and higher orders; along a slope contacts lower the order of all but RK4, whose two
// errors cancel to second order (see there).
TEST(SpeedStudy, MeasuresTheOrderOfEveryIntegratorOfOurs) {
  const std::vector<std::string> engines{
      "impulse:solver=exact,integrator=explicit-euler", "impulse:solver=exact,integrator=symplectic-euler",
      "impulse:solver=exact,integrator=velocity-verlet", "impulse:solver=exact,integrator=rk4", "impulse:substeps=4"};
  const std::map<std::string, std::vector<double>> theory{
      {"spring", {1, 1, 2, 4, 2}}, {"slope", {1, 1, 1, 2, 2}}, {"spinning-obb", {1, 1, 0, 0, 0}}};
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

TEST(SpeedStudy, AveragesOverPhasesWhereImpactsFallSomewhereInAStep) {
  const auto results = results_of(configuration({"bounce:e=0.8"}, {"impulse:solver=article,iterations=10"}, {"1/60"}));
  const Json& values = results.front().row.values;
  EXPECT_EQ(values.at("phases"), 8);
  EXPECT_LT(values.at("error_least"), values.at("error"));
  EXPECT_LT(values.at("error"), values.at("error_largest"));
}

TEST(SpeedStudy, WeighsByAConvergedReferenceWhereThereIsNoClosedForm) {
  const auto results = results_of(configuration({"pyramid:base=2,duration=0.5"}, {"impulse", "box2d"}, {"1/60"}));
  const Json& values = results.front().row.values;
  EXPECT_EQ(values.at("truth"), "converged");
  EXPECT_GT(values.at("truth_error"), 0);
  EXPECT_LT(values.at("truth_error"), 1e-3);
  EXPECT_EQ(values.at("status"), "ok");
}

TEST(SpeedStudy, SaysWhatIsNotSupported) {
  const auto results = results_of(configuration({"hanging-chain"}, {"impulse:solver=exact"}, {"1/60"}));
  for (const PointResult& result : results) {
    EXPECT_NE(result.row.values.at("status"), "ok") << result.key;
    EXPECT_FALSE(result.row.values.at("why").get<std::string>().empty());
    EXPECT_FALSE(result.row.values.contains("error"));
  }
}

TEST(SpeedStudy, TimesOnlyWhatRanToItsEnd) {
  for (const auto& [engine, timed] :
       {std::pair("impulse:solver=exact", false), std::pair("impulse:solver=xpbd", true)}) {
    const StudyPlan plan = Catalog<Study>::find("speed")->plan(configuration({"hanging-chain"}, {engine}, {"1/60"}));
    const Point& point = plan.points.front();
    point.prepare();
    const bool ran = point.run().values.contains("error");
    EXPECT_EQ(std::isfinite(point.turn()), ran && timed) << engine;
  }
}

TEST(SpeedStudy, ClimbsTheLadderOfEachMethodAndNamesEveryPointOnce) {
  const StudyPlan plan = Catalog<Study>::find("speed")->plan(configuration({"bounce:e=0.5"}, {}));
  std::map<std::string, int> keys;
  for (const Point& point : plan.points) EXPECT_EQ(++keys[point.key], 1) << point.key;
  for (const char* key :
       {"speed|bounce/e=0.5|impulse|substeps=8|dt=1/120", "speed|bounce/e=0.5|box2d|velocity=16|dt=1/960",
        "speed|bounce/e=0.5|impulse:solver=exact,integrator=rk4|dt=1/30",
        "speed|bounce/e=0.5|impulse:solver=xpbd|substeps=1|dt=1/60"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

// A run: s per simulated second and m.
PointResult fake(const std::string& engine, double dt, double time, double error) {
  const std::string step = std::to_string(dt);
  return {.key = "speed|s/v|" + engine + "|dt=" + step,
          .row = {{{"scenario", "s"},
                   {"variant", "v"},
                   {"engine", engine},
                   {"method", ""},
                   {"option", ""},
                   {"setting", ""},
                   {"standard", true},
                   {"dt", dt},
                   {"order", 0},
                   {"truth_error", 0.0},
                   {"round_off", 0.0},
                   {"error", error}},
                  {{"median", time}, {"wide", false}}}};
}

TEST(SpeedFindings, CompareAtEqualErrorAlongTheStandardsFront) {
  std::vector<PointResult> results;
  for (const double n : {1.0, 10.0, 100.0}) {
    results.push_back(fake("box2d", 1 / n, 1e-3 * n, 1 / n));
    results.push_back(fake("half", 1 / n, 0.5e-3 * n, 1 / n));
    results.push_back(fake("coarse", 1 / n, 1e-3 * n, 1e3 / n));
  }
  const Json timings =
      Catalog<Study>::find("speed")->plan(configuration({"spring"}, {"box2d"})).conclude(results).timings;
  std::map<std::string, Json> factors;
  for (const Json& row : timings.at("factors")) factors[row.at("engine")] = row;
  EXPECT_NEAR(factors["half"]["median"].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(factors["box2d"]["median"].get<double>(), 1, 1e-12);
  EXPECT_TRUE(factors["coarse"]["median"].is_null()) << "it is never so accurate";
  EXPECT_EQ(factors["coarse"]["reached"], 0);
  const Json& place = timings.at("cases").front();
  EXPECT_EQ(place.at("front").size(), 3u) << "all by the faster one";
  EXPECT_TRUE(place.at("engines")[0].at("time_for_error")[2].is_null()) << "1e-3 m was not reached";
  EXPECT_NEAR(place.at("engines")[0].at("time_for_error")[0].at("value").get<double>(), 1e-2, 1e-12);
}

}  // namespace
}  // namespace plumb
