#include "reports/run/converged_checks.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "reference/converged/converged.h"
#include "reports/run/selection.h"
#include "scenarios/parts.h"

namespace plumb::converged_checks_test {
namespace {

constexpr double frame = 1.0 / 60;

std::vector<double> frames(double duration) {
  std::vector<double> times;
  for (std::size_t i = 0; i <= steps_in(duration, frame); ++i) times.push_back(static_cast<double>(i) * frame);
  return times;
}

class DoublePendulum : public ::testing::Test {
 protected:
  DoublePendulum()
      : scene_(*parse_cases("double-pendulum:wild").front().scene),
        truth_(converged_truth(scene_, frames(2), {.tolerance = 0.01, .budget = 100'000})),
        checks_(scene_, truth_, frame) {}

  static Stepping stepping_of(const EngineConfig& config) { return config.engine->stepping(config.settings, frame); }

  std::vector<TruthCheck> judged(const Scene& scene, const Stepping& stepping) const {
    return checks_.of(stepping, *run(scene, ours_, frame).trace);
  }

  // Symplectic Euler, as it states itself.
  static constexpr Stepping first_order{
      .dt = frame, .h = frame, .drift = 0.5, .order = 1, .impact_lag = 1, .joint_slop = 0.005};

  Scene scene_;
  ConvergedTruth truth_;
  ConvergedChecks checks_;
  EngineConfig ours_ = parse_engine("impulse");
};

bool all_pass(const std::vector<TruthCheck>& checks) {
  return std::all_of(checks.begin(), checks.end(), [](const TruthCheck& one) { return one.passed; });
}

TEST_F(DoublePendulum, FindsOurEngineRight) {
  const auto checks = judged(scene_, stepping_of(ours_));
  EXPECT_GE(checks.size(), 10u);
  EXPECT_TRUE(all_pass(checks));
}

TEST_F(DoublePendulum, EveryCheckIsEvidence) {
  EXPECT_TRUE(checks_.knows_contact()) << "nothing ever touches";
  for (const Stepping& stepping : {stepping_of(ours_), first_order}) {
    const auto checks = judged(scene_, stepping);
    EXPECT_FALSE(checks.empty());
    EXPECT_TRUE(std::all_of(checks.begin(), checks.end(), [](const TruthCheck& one) { return is_evidence(one); }));
  }
}

TEST_F(DoublePendulum, JudgesAMethodOfLowerOrderForAShorterTime) {
  const auto latest = [](const std::vector<TruthCheck>& checks) {
    double time = 0;
    for (const TruthCheck& one : checks) time = std::max(time, one.time);
    return time;
  };
  EXPECT_LT(latest(judged(scene_, first_order)), latest(judged(scene_, stepping_of(ours_))));
}

TEST_F(DoublePendulum, StopsAnEngineInWhichNothingMoves) {
  const Trace moving = *run(scene_, ours_, frame).trace;
  Trace frozen(scene_.bodies.size());
  for (const double time : moving.times()) frozen.record(time, moving.states(0), {});
  EXPECT_FALSE(all_pass(checks_.of(first_order, frozen)));
}

TEST_F(DoublePendulum, StopsAnEngineWithWrongGravity) {
  Scene heavier = scene_;
  heavier.gravity.y *= 1.01;
  EXPECT_FALSE(all_pass(judged(heavier, stepping_of(ours_))));
  heavier.gravity.y *= 1.3;
  EXPECT_FALSE(all_pass(judged(heavier, first_order)));
}

// The reference of the billiard ends at the first impact, a tenth of a second after the start.
TEST(ConvergedChecks, AskNothingBeforeTheirBodyTouchesAnything) {
  const Case one = parse_cases("billiard:table").front();
  const auto truth = converged_reference(one, frame, usual_budget);
  ASSERT_TRUE(truth);
  const ConvergedChecks checks(*one.scene, *truth, frame);
  EXPECT_FALSE(checks.knows_contact());
  const EngineConfig ours = parse_engine("impulse");
  const auto all = checks.of(ours.engine->stepping(ours.settings, frame), *run(*one.scene, ours, frame).trace);
  EXPECT_FALSE(all.empty());
  for (const TruthCheck& check : all)
    EXPECT_TRUE(checks.precedes_touch(check.body, check.time)) << check.body << " " << check.quantity;
}

TEST_F(DoublePendulum, HasNothingToSayAboutAMethodWithHugeErrors) {
  Stepping rough = first_order;
  rough.joint_slop = 1;
  EXPECT_TRUE(judged(scene_, rough).empty());
}

// The disc lands a little after the last moment; an engine with a skin of 2 cm holds it a centimetre above the ground,
// and a step earlier.
TEST(ConvergedChecksOf, AllowAnEngineWithASkinToTouchAStepBeforeOurs) {
  Scene scene{.name = "landing", .gravity = {}, .duration = 2 * frame};
  scene.bodies = {level_ground({}), disc("disc", {0, 0.6005}, 0.5, {})};
  scene.bodies[1].velocity = {1, -3};
  const ConvergedTruth truth = converged_truth(scene, frames(scene.duration), {.tolerance = 0.01, .budget = 100'000});
  const ConvergedChecks checks(scene, truth, frame);
  Scene raised = scene;
  raised.bodies[0].position.y = 0.01;
  const Trace trace = *run(raised, parse_engine("impulse"), frame).trace;
  ASSERT_EQ(trace.states(2)[1].velocity.y, 0) << "it has landed";
  const Stepping thick{.dt = frame, .h = frame, .order = 1, .impact_lag = 1, .skin = 0.02, .looks_ahead = true};
  for (const TruthCheck& one : checks.of(thick, trace)) EXPECT_TRUE(one.passed) << one.quantity;
}

}  // namespace
}  // namespace plumb::converged_checks_test
