#include "reports/prove/prove.h"

#include <gmock/gmock.h>

#include <set>

#include "reports/prove/document.h"
#include "reports/run/selection.h"

namespace plumb {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double dt = 1.0 / 60;

void quiet(const std::string&, std::size_t, std::size_t) {}

Fault fault_called(const std::string& name) {
  for (const Fault& fault : all_faults()) {
    if (fault.name == name) return fault;
  }
  ADD_FAILURE() << name << " is not there";
  return {};
}

Proof proof_of(const Fault& fault, const std::string& scenario) {
  return prove({fault}, parse_cases(scenario), dt, 1, quiet).front();
}

TEST(Faults, AreFortyAndMoreEachWithANameAndALine) {
  std::set<std::string> names;
  for (const Fault& fault : all_faults()) {
    EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    EXPECT_NE(fault.about, "") << fault.name;
  }
  EXPECT_GE(names.size(), 40U);
}

TEST(Faults, HoldEveryMisprintOfTheSeed) {
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

TEST(Prove, CatchesATenthOfAPercentOfGravityByTheTruth) {
  const Proof proof = proof_of(fault_called("gravity-0.1-percent"), "spinning-obb:free-fall");
  ASSERT_TRUE(proof.caught());
  EXPECT_EQ(proof.best()->means, Means::truth);
  EXPECT_GT(proof.best()->ratio, 1);
}

TEST(Prove, CatchesDrawingThatRunsBackwards) {
  EXPECT_TRUE(proof_of(fault_called("interpolation-reversed"), "layers").caught());
  EXPECT_TRUE(proof_of(fault_called("interpolation-without-angles"), "layers").caught());
}

TEST(Prove, CatchesFrictionOfTheWrongSign) {
  const Proof proof = proof_of(fault_called("friction-sign"), "stopping-distance");
  EXPECT_TRUE(proof.caught());
  EXPECT_THAT(proof.scenarios(), ElementsAre("stopping-distance"));
}

TEST(Prove, CatchesWhatIsNotTheSameTwice) {
  const Proof proof = proof_of(fault_called("order-by-address"), "stacking");
  EXPECT_TRUE(proof.caught());
  EXPECT_THAT(proof.alarms, Contains(testing::Field(&Alarm::means, Means::repeat)));
}

TEST(Prove, DoesNotTakeOtherBitsForPhysics) {
  const Fault nudged{
      .name = "nudged", .about = "a start one rounding away", .build = [](Scene scene, const Settings& settings) {
        for (Body& body : scene.bodies) body.velocity.x *= 1 + 0x1p-52;
        return build_ours(scene, settings);
      }};
  const Proof proof = proof_of(nudged, "spinning-obb:flight");
  EXPECT_FALSE(proof.caught());
  EXPECT_EQ(proof.best(), nullptr);
  ASSERT_THAT(proof.alarms, SizeIs(1));
  EXPECT_EQ(proof.alarms.front().means, Means::bits);
  EXPECT_THAT(text_of({.proofs = {proof}}), HasSubstr("NOT SEEN: other bits alone"));
}

TEST(Prove, HasNothingAgainstTheRightEngine) {
  const Fault none{.name = "none", .about = "the engine as it is", .build = build_ours};
  EXPECT_THAT(proof_of(none, "bounce").alarms, IsEmpty());
  EXPECT_THAT(proof_of(none, "stacking").alarms, IsEmpty());
}

TEST(Prove, TakesARunThatDoesNotEndForCaught) {
  const Fault broken{.name = "broken",
                     .about = "ends at once",
                     .build = [](const Scene&, const Settings&) -> std::unique_ptr<Simulation> {
                       throw std::runtime_error("broken");
                     }};
  EXPECT_TRUE(proof_of(broken, "slope:sticks").caught());
}

TEST(Prove, IsTheSameForAnyNumberOfJobs) {
  const std::vector<Fault> faults{fault_called("energy-leak"), fault_called("restitution-2-percent")};
  const auto one = prove(faults, parse_cases("bounce"), dt, 1, quiet);
  const auto four = prove(faults, parse_cases("bounce"), dt, 4, quiet);
  EXPECT_EQ(to_json({.proofs = one}), to_json({.proofs = four}));
}

TEST(CleanRuns, RaiseNoAlarm) {
  const auto clean = clean_runs(4, parse_cases("spinning-obb"), dt, 1, quiet);
  ASSERT_THAT(clean, SizeIs(4));
  for (const CleanRun& run : clean) EXPECT_THAT(run.alarms, IsEmpty()) << run.settings;
}

Alarm alarm_in(const std::string& scenario) { return {.scenario = scenario, .ratio = 2}; }

TEST(FewestScenarios, CoverAllThatIsCaught) {
  const std::vector<Proof> proofs{{{.name = "one"}, {alarm_in("a"), alarm_in("b")}},
                                  {{.name = "two"}, {alarm_in("b")}},
                                  {{.name = "three"}, {alarm_in("b"), alarm_in("c")}},
                                  {{.name = "four"}, {alarm_in("d")}},
                                  {{.name = "unseen"}, {}}};
  EXPECT_THAT(fewest_scenarios(proofs), ElementsAre("b", "d"));
}

TEST(Proven, HoldsOnlyIfEveryFaultIsCaughtAndNoCleanRunAlarms) {
  const Proof caught{{.name = "one"}, {alarm_in("a")}};
  const Proof unseen{{.name = "two"}, {}};
  EXPECT_TRUE((Proven{.proofs = {caught}, .clean = {{1, "", {}}}}).holds());
  EXPECT_FALSE((Proven{.proofs = {caught, unseen}}).holds());
  EXPECT_FALSE((Proven{.proofs = {caught}, .clean = {{1, "", {alarm_in("a")}}}}).holds());
}

}  // namespace
}  // namespace plumb
