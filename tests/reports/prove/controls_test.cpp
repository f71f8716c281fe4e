#include "reports/prove/controls.h"

#include <gmock/gmock.h>

#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "reports/run/selection.h"

namespace plumb::controls_test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsNull;
using ::testing::NotNull;
using ::testing::SizeIs;

constexpr double dt = 1.0 / 60;

void silent(const std::string&, std::size_t, std::size_t) {}

ControlReport report_of(const Control& control, const std::string& scenario, const std::string& stated = "impulse",
                        int jobs = 1) {
  CaseTruths truths(dt);
  return prove_controls({control}, parse_cases(scenario), {parse_engine(stated)}, truths, jobs, silent).front();
}

ControlRun run_of(const std::string& control, const std::string& scenario, const std::string& stated = "impulse") {
  const Control* found = Catalog<Control>::find(control);
  if (found == nullptr) throw std::invalid_argument("there is no control " + control);
  return report_of(*found, scenario, stated).results.front().runs.at(0);
}

Control right_engine() { return {.name = "right", .about = "the engine as it is", .build = build_ours}; }

TEST(Controls, IncludeEveryLawThatAnEngineMayLack) {
  for (const char* name : {"frozen", "stopped", "coasting", "weightless", "half-gravity", "frictionless",
                           "no-restitution", "all-restitution", "no-rotation", "hoop-for-disc", "late", "teleporting",
                           "no-contacts", "forgetful", "unpowered", "unlimited", "pathless", "jointless"}) {
    ASSERT_THAT(Catalog<Control>::find(name), NotNull()) << name;
    EXPECT_NE(Catalog<Control>::find(name)->about, "") << name;
  }
}

TEST(Controls, AreNoEnginesToChooseFrom) {
  for (const Control* control : Catalog<Control>::all()) {
    EXPECT_THAT(Catalog<Engine>::find(control->name), IsNull()) << control->name;
  }
}

struct Unmasked {
  const char* control;
  const char* scenario;  // whose truth the control's law decides
};

class ControlsAreUnmasked : public ::testing::TestWithParam<Unmasked> {};

TEST_P(ControlsAreUnmasked, ByATruthOrAnInvariant) {
  const ControlRun run = run_of(GetParam().control, GetParam().scenario);
  EXPECT_THAT(run.unmasking, AnyOf(Unmasking::truth, Unmasking::invariant)) << name_of(run.unmasking);
  EXPECT_EQ(run.verdict, Verdict::wrong);
  ASSERT_TRUE(run.detection.has_value());
  EXPECT_GT(run.detection->ratio, 1);
}

INSTANTIATE_TEST_SUITE_P(
    All, ControlsAreUnmasked,
    ::testing::Values(Unmasked{"frozen", "bounce:e=0.8"}, Unmasked{"stopped", "slope:steep"},
                      Unmasked{"coasting", "bounce:e=0.8"}, Unmasked{"weightless", "spinning-obb:free-fall"},
                      Unmasked{"half-gravity", "spinning-obb:free-fall"}, Unmasked{"intangible", "bounce:e=0.8"},
                      Unmasked{"frictionless", "stopping-distance"}, Unmasked{"no-restitution", "bounce:e=0.8"},
                      Unmasked{"all-restitution", "bounce:e=0.5"}, Unmasked{"no-rotation", "slope-disc:rolls"},
                      Unmasked{"hoop-for-disc", "slope-disc:rolls"}, Unmasked{"late", "spinning-obb:free-fall"},
                      Unmasked{"teleporting", "bounce:e=0.8"}, Unmasked{"forgetful", "bounce:e=0.8"},
                      Unmasked{"unpowered", "motor:slow"}, Unmasked{"unpowered", "motor-arm:holds"},
                      Unmasked{"unpowered", "four-bar:3rad/s"}, Unmasked{"unlimited", "rail-stop:slides"},
                      Unmasked{"unlimited", "joint-stop:60deg"}, Unmasked{"pathless", "juggler:orbit"},
                      Unmasked{"frictionless", "stick-slip:slow"}, Unmasked{"frozen", "catenary:seven"},
                      Unmasked{"jointless", "cantilever:four"}, Unmasked{"jointless", "hanging-chain:still"},
                      Unmasked{"jointless", "joint-grid:seven"}, Unmasked{"jointless", "rope-bridge:light"},
                      Unmasked{"jointless", "rope-bridge:heavy"}),
    [](const auto& of) {
      std::string name = std::string(of.param.control) + '_' + of.param.scenario;
      std::erase_if(name, [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; });
      return name;
    });

// Nothing is asked about the fall itself, or about places.
TEST(Controls, AreUnmaskedWithoutExpectationsOfTheirLaw) {
  for (const char* control : {"half-gravity", "late"}) {
    const ControlRun run = run_of(control, "joint-stop:60deg");
    EXPECT_EQ(run.unmasking, Unmasking::invariant) << control;
    EXPECT_EQ(run.detection->metric, "free_motion");
  }
  EXPECT_EQ(run_of("no-rotation", "smash").unmasking, Unmasking::invariant);
  EXPECT_EQ(run_of("no-restitution", "capsule-heap:six").unmasking, Unmasking::truth) << "by the converged reference";
}

// The boxes' reference ends within a step or two after the first hits the drum.
TEST(Controls, AreComparedAsLongAsTheMotionIsKnown) {
  const ControlRun run = run_of("no-restitution", "tumbler:boxes");
  EXPECT_EQ(run.unmasking, Unmasking::same);
  EXPECT_LT(run.difference, right_share);
}

TEST(Controls, MayBeRightWhereTheirLawDoesNotMatter) {
  EXPECT_EQ(run_of("frozen", "slope:sticks").unmasking, Unmasking::same);
  EXPECT_EQ(run_of("all-restitution", "bounce:e=1").unmasking, Unmasking::same);
  EXPECT_EQ(run_of("frictionless", "spinning-obb:flight").unmasking, Unmasking::same);
}

TEST(Controls, AreNeverRightAboutLoadsThatTheyDoNotReport) {
  const ControlRun run = run_of("no-contacts", "stacking:one");
  EXPECT_TRUE(std::isinf(run.difference));
  EXPECT_EQ(run.verdict, Verdict::no_evidence);
  EXPECT_EQ(run.unmasking, Unmasking::inconclusive);
}

TEST(Controls, AreJudgedByTheStatementOfAnotherEngine) {
  const double strict = run_of("frozen", "spinning-obb:free-fall").detection->tolerance;
  const ControlRun lenient = run_of("frozen", "spinning-obb:free-fall", "box2d");
  EXPECT_EQ(lenient.verdict, Verdict::wrong);
  EXPECT_GT(lenient.detection->tolerance, strict);
}

TEST(ProveControls, FindsNothingWrongWithTheRightEngine) {
  const ControlReport report = report_of(right_engine(), "bounce");
  EXPECT_EQ(report.passes(), 0U);
  EXPECT_EQ(report.results[0].count(Unmasking::same), report.results[0].runs.size());
  EXPECT_THAT(report.results[0].best(), IsNull());
}

// Only the height is asked, and an engine that states a round-off of 1 is allowed any motion by the invariants.
TEST(ProveControls, CountsARightVerdictOnAnotherMotionAsAPass) {
  Scenario asked = *Catalog<Scenario>::find("spinning-obb");
  asked.expectations = [](const Parameters&) -> std::vector<Expectation> {
    return {{.body = "box", .quantity = Quantity::y, .within = 1e-3}};
  };
  Case one_case = parse_case("spinning-obb:free-fall");
  one_case.scenario = &asked;
  Engine lenient = *Catalog<Engine>::find("impulse");
  lenient.stepping = [](const Settings&, double step) { return Stepping{.dt = step, .h = step, .epsilon = 1}; };
  const auto turning = [](Scene scene, const Settings& settings) {
    scene.forces.push_back(Constant{.body = 1, .torque = 1});
    return build_ours(scene, settings);
  };
  CaseTruths truths(dt);
  const ControlReport report = prove_controls({{.name = "turning", .about = "is turned", .build = turning}}, {one_case},
                                              {{&lenient, complete(lenient, {})}}, truths, 1, silent)
                                   .front();
  EXPECT_GT(report.results[0].runs.at(0).difference, right_share);
  EXPECT_EQ(report.results[0].runs.at(0).unmasking, Unmasking::passes) << text_of(report, true);
  EXPECT_EQ(report.passes(), 1U);
  EXPECT_THAT(text_of(report, false), HasSubstr("FALSE PASS of turning: spinning-obb"));
}

TEST(ProveControls, UnmasksAControlThatStops) {
  const Control broken{.name = "broken",
                       .about = "ends at once",
                       .build = [](const Scene&, const Settings&) -> std::unique_ptr<Simulation> {
                         throw std::runtime_error("broken");
                       }};
  EXPECT_EQ(report_of(broken, "slope:sticks").results[0].count(Unmasking::invariant), 1U);
}

TEST(ProveControls, IsTheSameForAnyNumberOfJobs) {
  const Control& frozen = *Catalog<Control>::find("frozen");
  EXPECT_EQ(to_json({report_of(frozen, "bounce", "impulse", 1)}), to_json({report_of(frozen, "bounce", "impulse", 4)}));
}

TEST(ProveControls, SaysWhatBecameOfAControlInEachCase) {
  const ControlReport report = report_of(*Catalog<Control>::find("frozen"), "slope");
  const std::string text = text_of(report, true);
  for (const ControlRun& run : report.results[0].runs) EXPECT_THAT(text, HasSubstr("slope " + run.variant));
  const auto json = to_json({report});
  EXPECT_THAT(json["statements"][0]["controls"][0]["runs"], SizeIs(report.results[0].runs.size()));
  EXPECT_EQ(json["statements"][0]["stated_by"], "impulse");
}

}  // namespace
}  // namespace plumb::controls_test
