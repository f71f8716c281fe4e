#include "reports/prove/sensitivity.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/prove/report.h"
#include "reports/run/selection.h"
#include "scenarios/parts.h"

namespace plumb::sensitivity_test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double dt = 1.0 / 60;

void silent(const std::string&, std::size_t, std::size_t) {}

Perturbation parameter_called(const std::string& name) {
  for (const Perturbation& one : all_perturbations()) {
    if (one.name == name) return one;
  }
  ADD_FAILURE() << "there is no parameter " << name;
  return {};
}

Sensitivity sensitivity_to(const std::string& parameter, const std::vector<Case>& cases, int jobs = 1) {
  CaseTruths truths(dt);
  return sensitivities({parameter_called(parameter)}, cases, engine_statements(), truths, jobs, silent)
      .parameters.front();
}

constexpr double speed = 4;         // m/s
constexpr double damping = 0.5;     // 1/s
constexpr double tolerance = 0.01;  // m/s

// A disc slows down for a second; its speed is checked with the same tolerance for any engine, large against the error
// of any method.
Scenario slowing_disc() {
  Scenario made{.name = "slowing-disc"};
  made.scene = [](const Parameters&) {
    Scene scene{.name = "slowing-disc", .gravity = {0, 0}, .duration = 1};
    scene.bodies.push_back(disc("disc", {0, 0}, 1, {}));
    scene.bodies[0].velocity = {speed, 0};
    scene.bodies[0].linear_damping = damping;
    return scene;
  };
  made.expectations = [](const Parameters&) {
    return std::vector<Expectation>{
        {.body = "disc", .quantity = Quantity::vx, .expected = speed * std::exp(-damping), .within = tolerance}};
  };
  return made;
}

Case case_of(const Scenario& scenario) {
  return {.scenario = &scenario, .scene = std::make_shared<const Scene>(scenario.scene({}))};
}

TEST(Sensitivity, IsTheToleranceDividedByTheDerivativeOfALinearCheck) {
  const Scenario scenario = slowing_disc();
  const Sensitivity found = sensitivity_to("linear damping", {case_of(scenario)});
  const double derivative = speed * damping * std::exp(-damping);
  ASSERT_FALSE(found.sighted.empty());
  const auto& box2d = found.sighted[1];
  ASSERT_TRUE(box2d.has_value());
  EXPECT_GE(std::abs(box2d->error), 0.97 * tolerance / derivative);
  EXPECT_LE(std::abs(box2d->error), 1.03 * error_precision * tolerance / derivative);
  EXPECT_EQ(box2d->detection.metric, "disc vx");
}

TEST(Sensitivity, IsUnknownToAParameterThatNoCaseHas) {
  const Scenario scenario = slowing_disc();
  const Sensitivity found = sensitivity_to("gravity", {case_of(scenario)});
  EXPECT_EQ(found.cases, 0U);
  const std::vector<EngineStatement> statements = engine_statements();
  for (std::size_t s = 0; s < statements.size(); ++s) {
    EXPECT_FALSE(found.sighted[s].has_value());
    EXPECT_EQ(found.reaches(s, statements[s]), !statements[s].goal.has_value());
  }
}

TEST(Sensitivity, TakesNoRefusalForASighting) {
  const Sensitivity found = sensitivity_to("restitution", parse_cases("bounce:e=1"));
  ASSERT_TRUE(found.sighted[0].has_value());
  EXPECT_LT(found.sighted[0]->error, 0) << "a restitution above 1 is refused";
}

TEST(Sensitivity, IsFinerByOurStatementThanByThatOfAFirstOrderEngine) {
  const Sensitivity found = sensitivity_to("gravity", parse_cases("spinning-obb:flight"));
  ASSERT_TRUE(found.sighted[0] && found.sighted[1]);
  EXPECT_LT(std::abs(found.sighted[0]->error), 1e-4);
  EXPECT_LT(std::abs(found.sighted[0]->error), std::abs(found.sighted[1]->error));
}

TEST(Sensitivity, IsTheSameForAnyNumberOfJobs) {
  const auto report = [](int jobs) {
    return to_json(
        SensitivityReport{engine_statements(), {{sensitivity_to("mass", parse_cases("head-on"), jobs)}, {}}});
  };
  EXPECT_EQ(report(1), report(4));
}

TEST(Perturbations, OfSizeZeroAreNotSeen) {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  for (const std::string name : {"head-on", "stopping-distance", "pendulum"}) {
    const Case one = parse_cases(name).front();
    const CaseTruth truth(one, dt, usual_budget);
    const JudgedRun right = judge_two_runs(one, {&ours, complete(ours, {})}, dt, truth);
    for (const Perturbation& parameter : all_perturbations()) {
      const Engine engine = perturbed_engine(parameter, 0);
      const JudgedRun same = judge_two_runs(one, {&engine, complete(engine, {})}, dt, truth);
      EXPECT_THAT(physics_detections(one, right, same), SizeIs(0)) << parameter.name << " in " << name;
    }
  }
}

TEST(Perturbations, AreEachOfAParameterThatSomeCaseHas) {
  std::set<std::string> names;
  const std::vector<Case> cases = default_cases(true);
  for (const Perturbation& parameter : all_perturbations()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    EXPECT_NE(parameter.about, "") << parameter.name;
    EXPECT_TRUE(std::any_of(cases.begin(), cases.end(), [&](const Case& one) { return parameter.applies(*one.scene); }))
        << parameter.name;
  }
}

TEST(SensitivityReport, PassesOnlyIfEveryGoalIsReached) {
  const std::vector<EngineStatement> statements{{"ours", {}, 1e-4}, {"other", {}, std::nullopt}};
  Sensitivity fine{.parameter = {.name = "gravity"}, .sighted = {Sighting{-1e-4, {}}, std::nullopt}};
  EXPECT_TRUE((SensitivityReport{statements, {{fine}, {}}}).passed());
  fine.sighted[0]->error = -1.1e-4;
  const SensitivityReport missed{statements, {{fine}, {}}};
  EXPECT_FALSE(missed.passed());
  EXPECT_THAT(text_of(missed), HasSubstr("MISSES ITS GOAL"));
}

TEST(SensitivityReport, ListsEachParameterInARowOfMarkdown) {
  const Sighting seen{-2e-6, {.scenario = "bounce", .variant = "e=1", .metric = "disc apex"}};
  const SensitivityReport report{{{"impulse", {}, 1e-4}, {"box2d", {}, 0.02}},
                                 {{{.parameter = {.name = "gravity"}, .sighted = {seen, std::nullopt}}}, {}}};
  EXPECT_THAT(markdown_of(report), HasSubstr("| gravity | 2.0e-06 | bounce:e=1, disc apex | over 10 % | - |\n"));
}

}  // namespace
}  // namespace plumb::sensitivity_test
