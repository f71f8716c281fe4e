#include "reports/prove/prove.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "reports/prove/report.h"
#include "reports/run/selection.h"

namespace plumb::prove_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double dt = 1.0 / 60;

void silent(const std::string&, std::size_t, std::size_t) {}

Fault fault_called(const std::string& name) {
  for (const Fault& fault : all_faults()) {
    if (fault.name == name) return fault;
  }
  ADD_FAILURE() << "there is no fault " << name;
  return {};
}

FaultResult result_of(const Fault& fault, const std::string& scenario) {
  CaseTruths truths(dt);
  return prove({fault}, parse_cases(scenario), truths, 1, silent).front();
}

TEST(Faults, AreAtLeastFortyWithUniqueNamesAndDescriptions) {
  std::set<std::string> names;
  for (const Fault& fault : all_faults()) {
    EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    EXPECT_NE(fault.about, "") << fault.name;
  }
  EXPECT_GE(names.size(), 40U);
}

TEST(Faults, IncludeEveryMisprintOfTheArticle) {
  std::set<std::string> names;
  for (const Fault& fault : all_faults()) names.insert(fault.name);
  for (const char* misprint :
       {"explicit-for-symplectic", "interpolation-reversed", "interpolation-without-angles", "inertia-of-hoop",
        "pairs-doubled", "impulse-sign", "impulse-one-plus-e", "friction-bounces", "friction-along-normal",
        "friction-sign", "friction-no-clamp", "friction-mixed-by-average", "friction-mixed-otherwise", "torque-of-spin",
        "force-times-gravity", "columns-swapped"}) {
    EXPECT_THAT(names, Contains(misprint));
  }
}

TEST(Faults, AreNotOfferedAsMethods) {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  for (const Fault& fault : all_faults()) {
    for (const Option& option : ours.options) {
      for (const auto& [choice, about] : option.choices) EXPECT_NE(choice, fault.name);
    }
  }
}

TEST(Prove, CatchesGravityThatIsOffByATenthOfAPercent) {
  const FaultResult result = result_of(fault_called("gravity-0.1-percent"), "spinning-obb:free-fall");
  ASSERT_TRUE(result.caught());
  EXPECT_TRUE(result.caught_by_physics());
  EXPECT_GT(result.best()->ratio, 1);
}

TEST(Prove, CatchesReversedInterpolation) {
  EXPECT_TRUE(result_of(fault_called("interpolation-reversed"), "layers").caught());
  EXPECT_TRUE(result_of(fault_called("interpolation-without-angles"), "layers").caught());
}

TEST(Prove, CatchesFrictionOfTheWrongSign) {
  const FaultResult result = result_of(fault_called("friction-sign"), "stopping-distance");
  EXPECT_TRUE(result.caught());
  EXPECT_THAT(result.scenarios(), ElementsAre("stopping-distance"));
}

TEST(Prove, CatchesRunsThatDoNotRepeat) {
  const FaultResult result = result_of(fault_called("order-by-address"), "stacking");
  EXPECT_TRUE(result.caught());
  EXPECT_THAT(result.detections, Contains(testing::Field(&Detection::kind, DetectionKind::repeat)));
}

TEST(Prove, DoesNotCountChangedBitsAsCaught) {
  const Fault nudged{.name = "nudged",
                     .about = "a start that differs by one rounding",
                     .build = [](Scene scene, const Settings& settings) {
                       for (Body& body : scene.bodies) body.velocity.x *= 1 + 0x1p-52;
                       return build_ours(scene, settings);
                     }};
  const FaultResult result = result_of(nudged, "spinning-obb:flight");
  EXPECT_FALSE(result.caught());
  EXPECT_EQ(result.best(), nullptr);
  ASSERT_THAT(result.detections, SizeIs(1));
  EXPECT_EQ(result.detections.front().kind, DetectionKind::bits);
  EXPECT_THAT(text_of({.faults = {result}}), HasSubstr("NOT SEEN: only bits differ"));
}

TEST(Prove, DetectsNothingInTheRightEngine) {
  const Fault none{.name = "none", .about = "the engine as it is", .build = build_ours};
  EXPECT_THAT(result_of(none, "bounce").detections, IsEmpty());
  EXPECT_THAT(result_of(none, "stacking").detections, IsEmpty());
}

TEST(Prove, CatchesARunThatFails) {
  const Fault broken{.name = "broken",
                     .about = "ends at once",
                     .build = [](const Scene&, const Settings&) -> std::unique_ptr<Simulation> {
                       throw std::runtime_error("broken");
                     }};
  EXPECT_TRUE(result_of(broken, "slope:sticks").caught());
}

TEST(Prove, IsTheSameForAnyNumberOfJobs) {
  const std::vector<Fault> faults{fault_called("energy-leak"), fault_called("restitution-2-percent")};
  CaseTruths truths(dt);
  const auto one = prove(faults, parse_cases("bounce"), truths, 1, silent);
  const auto four = prove(faults, parse_cases("bounce"), truths, 4, silent);
  EXPECT_EQ(to_json({.faults = one}), to_json({.faults = four}));
}

TEST(CleanRuns, RaiseNoFalseAlarm) {
  CaseTruths truths(dt);
  const auto clean = clean_runs(4, parse_cases("spinning-obb"), truths, 1, silent);
  ASSERT_THAT(clean, SizeIs(4));
  for (const CleanRun& run : clean) EXPECT_THAT(run.false_alarms, IsEmpty()) << run.settings;
}

TEST(CleanRuns, IncludeTheDefaultSettings) {
  CaseTruths truths(dt);
  const CleanRun run = default_run(parse_cases("spinning-obb"), truths, 1, silent);
  EXPECT_EQ(run.seed, 0U);
  EXPECT_EQ(run.settings, "default settings");
  EXPECT_THAT(run.false_alarms, IsEmpty());
}

// Asks for a place that the body never reaches: every right engine fails it.
Case case_of(const Scenario& impossible) {
  Case one = parse_cases("spinning-obb:flight").front();
  one.scenario = &impossible;
  return one;
}

Scenario impossible_scenario() {
  const Case sound = parse_cases("spinning-obb:flight").front();
  Scenario impossible = *sound.scenario;
  const std::string body = sound.scene->bodies.front().name;
  impossible.expectations = [body](const Parameters&) {
    return std::vector<Expectation>{
        {.body = body, .quantity = Quantity::x, .expected = 1e6, .within = 1.0, .source = "nowhere"}};
  };
  return impossible;
}

TEST(CleanRuns, CountWhatTheDefaultFailsItself) {
  const Scenario impossible = impossible_scenario();
  const std::vector<Case> cases{case_of(impossible)};
  CaseTruths truths(dt);
  const CleanRun own = default_run(cases, truths, 1, silent);
  ASSERT_THAT(own.false_alarms, SizeIs(1));
  EXPECT_EQ(own.false_alarms.front().kind, DetectionKind::truth);
  EXPECT_THAT(clean_runs(1, cases, truths, 1, silent).front().false_alarms, SizeIs(1));

  const ProveReport report{.clean = {own}, .cases = 1};
  EXPECT_FALSE(report.passed());
  EXPECT_THAT(text_of(report), HasSubstr("false alarms in 1 of 1 clean runs"));
  EXPECT_THAT(text_of(report), HasSubstr("FALSE ALARM in spinning-obb flight"));
}

TEST(CleanRuns, TellEachTruthThatTheDefaultCannotFail) {
  Scenario loose = impossible_scenario();
  const auto impossible = loose.expectations;
  loose.expectations = [impossible](const Parameters& p) {
    std::vector<Expectation> all = impossible(p);
    all.front().within = 1e7;
    return all;
  };
  CaseTruths truths(dt);
  const CleanRun own = default_run({case_of(loose)}, truths, 1, silent);
  EXPECT_THAT(own.false_alarms, IsEmpty());
  ASSERT_THAT(own.loose, SizeIs(1));
  EXPECT_GT(own.loose.front().check.share, 1);
  EXPECT_THAT(clean_runs(1, {case_of(loose)}, truths, 1, silent).front().loose, IsEmpty());

  const ProveReport report{.clean = {own}, .cases = 1};
  EXPECT_FALSE(report.passed());
  EXPECT_THAT(text_of(report), HasSubstr("NOT A TEST in spinning-obb flight, x of "));
}

TEST(CleanRuns, CountARunThatFailsOrDoesNotRepeat) {
  const Case one = parse_cases("spinning-obb:flight").front();
  EXPECT_THAT(false_alarms(one, {.status = Status::failed, .reason = "diverged"}),
              ElementsAre(testing::Field(&Detection::metric, "the run's end")));
  EXPECT_THAT(false_alarms(one, {.repeatable = false}),
              ElementsAre(testing::Field(&Detection::kind, DetectionKind::repeat)));
  EXPECT_THAT(false_alarms(one, {}), IsEmpty());
}

TEST(ProveReport, PrintsEachFalseAlarmOnceWithItsWorstRun) {
  const auto alarm = [](double error) {
    return Detection{.scenario = "arch", .variant = "thin", .metric = "cone", .error = error, .ratio = error};
  };
  const std::string text =
      text_of({.clean = {{0, "default settings", {alarm(2)}}, {1, "seed 1", {alarm(3), alarm(2.5)}}}});
  EXPECT_THAT(text, HasSubstr("FALSE ALARM in arch thin, cone: 3 where 0 is allowed (3 x allowed), with seed 1; in 2 "
                              "clean runs\n"));
  EXPECT_EQ(text.find("FALSE ALARM"), text.rfind("FALSE ALARM"));
}

Detection detection_in(const std::string& scenario) { return {.scenario = scenario, .ratio = 2}; }

TEST(FewestScenarios, CoverEveryCaughtFault) {
  const std::vector<FaultResult> results{{{.name = "one"}, {detection_in("a"), detection_in("b")}},
                                         {{.name = "two"}, {detection_in("b")}},
                                         {{.name = "three"}, {detection_in("b"), detection_in("c")}},
                                         {{.name = "four"}, {detection_in("d")}},
                                         {{.name = "unseen"}, {}}};
  EXPECT_THAT(fewest_scenarios(results), ElementsAre("b", "d"));
}

TEST(ProveReport, PassesOnlyIfEveryFaultIsCaughtWithoutAFalseAlarm) {
  const FaultResult caught{{.name = "one"}, {detection_in("a")}};
  const FaultResult missed{{.name = "two"}, {}};
  EXPECT_TRUE((ProveReport{.faults = {caught}, .clean = {{1, "", {}}}}).passed());
  EXPECT_FALSE((ProveReport{.faults = {caught, missed}}).passed());
  EXPECT_FALSE((ProveReport{.faults = {caught}, .clean = {{1, "", {detection_in("a")}}}}).passed());
}

TEST(Variation, ChangesNoParameterExceptTheSeed) {
  bool seeded = false;
  for (const Case& one : default_cases(true)) {
    const Case varied = variation_of(7).of(one);
    for (const Parameter& parameter : one.scenario->parameters) {
      const double was = one.parameters.at(parameter.name);
      const double is = varied.parameters.at(parameter.name);
      if (parameter.name == "seed") {
        EXPECT_EQ(is, parameter.min + 7) << one.scenario->name;
        seeded = true;
      } else {
        EXPECT_EQ(is, was) << one.scenario->name;
      }
    }
  }
  EXPECT_TRUE(seeded);
}

TEST(Variation, DependsOnTheSeedAlone) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(variation_of(seed).text(), variation_of(seed).text());
    texts.insert(variation_of(seed).text());
  }
  EXPECT_EQ(texts.size(), 20U) << "the text contains the seed";
}

}  // namespace
}  // namespace plumb::prove_test
