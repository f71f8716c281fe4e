#include "reports/run/case_run.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <optional>

#include "reports/run/experiment.h"
#include "reports/run/selection.h"
#include "reports/writers/json.h"
#include "scenarios/scene/vec.h"

namespace plumb::case_run_test {
namespace {

using ::testing::IsNull;
using ::testing::NotNull;

constexpr double dt = 1.0 / 60;

TEST(Phases, StartWithTheCaseItselfAndFillAStepEvenly) {
  const auto all = phases(parse_case("bounce"), 8);
  ASSERT_EQ(all.size(), 8u);
  EXPECT_EQ(all.front().first_step, 1);
  std::vector<double> shares;
  for (const Case& one : all) shares.push_back(one.first_step);
  std::sort(shares.begin(), shares.end());
  double before = 0;
  for (const double share : shares) {
    EXPECT_GT(share, before);
    EXPECT_LT(share - before, 2.0 / 8) << "an even filling has gaps of 1/8";
    before = share;
  }
  EXPECT_EQ(phases(parse_case("bounce"), 1).size(), 1u);
}

TEST(Phases, EndWithTheScene) {
  const Case test_case = parse_case("bounce");
  for (const Case& one : phases(test_case, 5)) {
    const Outcome outcome = run(*one.scene, parse_engine("impulse"), dt, one.first_step);
    ASSERT_EQ(outcome.status, Status::ok);
    EXPECT_DOUBLE_EQ(outcome.trace->time(1), one.first_step * dt);
    EXPECT_NEAR(outcome.trace->times().back(), test_case.scene->duration, 1e-9);
  }
}

Judgement judged(const Case& test_case, const EngineConfig& config) {
  const Truth truth(*test_case.closed_form, *test_case.scene);
  const CaseRun runs = run_case(test_case, config, dt);
  return judge_case(test_case, config, dt, *runs.outcome.trace, runs.shifted, {.truth = &truth});
}

// An impact that is noticed at the end of its step is late by anything from zero to a step; one whose time is computed
// is not late at all.
TEST(Phases, SpreadTheErrorOfImpactsThatAreNoticedLate) {
  const Case test_case = parse_cases("head-on:e=0.5").front();
  const Judgement late = judged(test_case, parse_engine("impulse:solver=article"));
  const Judgement exact = judged(test_case, parse_engine("impulse"));
  EXPECT_EQ(late.verdict, Verdict::coarse);
  EXPECT_EQ(exact.verdict, Verdict::right);
  ASSERT_EQ(late.checks.size(), 4u);
  const TruthCheck& x = late.checks[1];
  ASSERT_EQ(x.quantity, "x");
  ASSERT_TRUE(x.spread);
  EXPECT_EQ(x.spread->phases, judged_phases);
  EXPECT_EQ(x.error, x.spread->max) << "the worst phase is judged";
  EXPECT_LT(x.spread->min, 0.3 * x.spread->max);
  EXPECT_LE(x.spread->min, x.spread->median);
  EXPECT_LE(x.spread->median, x.spread->max);
  EXPECT_LT(exact.checks[1].spread->max, 1e-12);
}

TEST(Phases, AreWrongIfOneIs) {
  const Case test_case = parse_cases("corner-impact:e=1").front();
  Engine lucky = *Catalog<Engine>::find("impulse");
  // Correct only for whole steps.
  class Lucky : public Simulation {
   public:
    explicit Lucky(std::unique_ptr<Simulation> with) : with_(std::move(with)) {}
    void step(double h) override {
      with_->step(h);
      broken_ = broken_ || std::abs(h - dt) > 1e-9;
    }
    void read(std::span<BodyState> out) const override {
      with_->read(out);
      if (broken_) out.back().velocity.y += 1;
    }

   private:
    std::unique_ptr<Simulation> with_;
    bool broken_ = false;
  };
  lucky.build = [](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
    return std::make_unique<Lucky>(Catalog<Engine>::find("impulse")->build(scene, settings));
  };
  const Judgement judgement = judged(test_case, {&lucky, complete(lucky, {})});
  EXPECT_EQ(judgement.verdict, Verdict::wrong);
  EXPECT_FALSE(judgement.checks[0].passed);
  EXPECT_LT(judgement.checks[0].spread->min, 1e-9);
  EXPECT_NEAR(judgement.checks[0].spread->max, 1, 1e-9);
}

// The second corner lands some .02 s after the first, long before the end, when all values are asked for.
const char* const lands_twice = "corner-impact:tilt=11.8,speed=10.4,restitution=0.11";

TEST(JudgeCase, LeavesOutWhatTheClosedFormDoesNotReach) {
  const Case test_case = parse_case(lands_twice);
  const Truth truth(*test_case.closed_form, *test_case.scene);
  const EngineConfig config = parse_engine("impulse");
  const RunRecord record = judged_record(test_case, config, dt, run_case(test_case, config, dt), {.truth = &truth});
  EXPECT_EQ(record.verdict, Verdict::plausible);
  EXPECT_TRUE(record.truth.empty());
  EXPECT_EQ(record.reason, "4 of 4 values not judged: the closed form ends at 0.1237 s");
}

TEST(JudgeCase, LeavesOutWhatTheClosedFormDoesNotHandle) {
  // The slip at the corner reverses, where the classical laws disagree.
  const Case test_case =
      parse_case("spinning-obb:height=1.04,vy=-20,spin=89,friction=0.74,restitution=0.94,duration=1");
  const EngineConfig config = parse_engine("impulse");
  ASSERT_NE(test_case.closed_form->unsupported(*test_case.scene, {}), "");
  const RunRecord record = judged_record(test_case, config, dt, run_case(test_case, config, dt), {});
  EXPECT_EQ(record.verdict, Verdict::plausible);
  EXPECT_EQ(record.reason, "6 of 6 values not judged: the closed form does not handle these parameters");
}

// A control: the laws that hold in any scene still stop an engine where the closed form does not reach.
TEST(JudgeCase, CallsABrokenLawWrongWhereTheClosedFormDoesNotReach) {
  const Case test_case = parse_case(lands_twice);
  const Truth truth(*test_case.closed_form, *test_case.scene);
  Case altered = test_case;
  Scene scene = *test_case.scene;
  scene.bodies.back().velocity = 0.5 * scene.bodies.back().velocity;
  altered.scene = std::make_shared<const Scene>(scene);
  const EngineConfig config = parse_engine("impulse");
  const CaseRun slower = run_case(altered, config, dt);
  EXPECT_EQ(judge_case(test_case, config, dt, *slower.outcome.trace, slower.shifted, {.truth = &truth}).verdict,
            Verdict::wrong);
}

TEST(Questions, AreNotAnsweredByTheOthersAlone) {
  const Case test_case = parse_case(lands_twice);
  const Truth truth(*test_case.closed_form, *test_case.scene);
  const Questions questions = questions_of(test_case, {.truth = &truth});
  ASSERT_EQ(questions.open.size(), 4u);
  const TruthCheck exact{.quantity = "vy", .tolerance = 1e-6, .scale = 1, .passed = true};
  EXPECT_EQ(verdict_of({&exact, 1}, {}), Verdict::right);
  EXPECT_EQ(questions.verdict({&exact, 1}, {}), Verdict::no_evidence);
  TruthCheck failed = exact;
  failed.passed = false;
  EXPECT_EQ(questions.verdict({&failed, 1}, {}), Verdict::wrong);
}

TEST(Questions, OfEveryVariantOfTheCatalogueAreAnswered) {
  for (const Case& test_case : default_cases(true)) {
    if (test_case.closed_form == nullptr) continue;
    std::optional<Truth> truth;
    if (test_case.closed_form->unsupported(*test_case.scene, {}).empty()) {
      truth.emplace(*test_case.closed_form, *test_case.scene);
    }
    const Questions questions = questions_of(test_case, {.truth = truth ? &*truth : nullptr});
    EXPECT_EQ(questions.reason, "") << test_case.scenario->name << " " << test_case.variant;
  }
}

TEST(RunCase, RunsOtherPhasesOnlyOfAPhasedScenarioThatRan) {
  EXPECT_EQ(run_case(parse_cases("head-on:e=0.5").front(), parse_engine("impulse"), dt).shifted.size(),
            judged_phases - 1u);
  EXPECT_TRUE(run_case(parse_case("spring"), parse_engine("impulse"), dt).shifted.empty());
}

TEST(Phases, AreInTheReportOfAPhasedScenario) {
  Plan plan{.cases = {parse_cases("head-on:e=0.5").front(), parse_cases("spring").front()},
            .configs = {parse_engine("impulse")}};
  const auto json = to_json(run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {}));
  EXPECT_EQ(json["runs"][1]["truth"][0]["phases"]["count"], judged_phases);
  EXPECT_TRUE(json["runs"][3]["truth"][0]["phases"].is_null());
}

TEST(CaseTruth, IsTheClosedFormWhereThereIsOne) {
  const Case one = parse_cases("bounce:e=0.8").front();
  const CaseTruth truth(one, dt, usual_budget);
  EXPECT_EQ(truth.engine(), one.closed_form);
  EXPECT_THAT(truth.converged(), IsNull());
  EXPECT_THAT(truth.reference().truth, NotNull());
  EXPECT_THAT(truth.reference().converged, IsNull());
  EXPECT_TRUE(std::isinf(truth.valid_until()));
}

TEST(CaseTruth, IsAConvergedReferenceWhereThereIsNone) {
  const Case one = parse_cases("double-pendulum:wild").front();
  const CaseTruth truth(one, dt, usual_budget);
  ASSERT_THAT(truth.converged(), NotNull());
  EXPECT_THAT(truth.reference().converged, NotNull());
  EXPECT_LT(truth.valid_until(), one.scene->duration) << "it is chaotic";
  EXPECT_THAT(CaseTruth(one, dt, 0).engine(), IsNull()) << "no budget";
}

// An engine is given the mean velocity of each step, which no method is to blame for.
TEST(CaseTruth, IsNoConvergedReferenceWhereBodiesFollowPaths) {
  EXPECT_THAT(CaseTruth(parse_cases("juggler:orbit").front(), dt, usual_budget).engine(), IsNull());
}

TEST(CaseTruths, AreFoundOnceForAllCopiesOfACase) {
  CaseTruths truths(dt);
  const Case one = parse_cases("bounce:e=0.8").front();
  Case shifted = one;
  shifted.first_step = 0.5;
  EXPECT_EQ(&truths.of(one), &truths.of(shifted));
  EXPECT_NE(&truths.of(one), &truths.of(parse_cases("bounce:e=0.8").front()));
}

// The reference knows the fall, the statement of a rough method nothing that happens after it.
TEST(CaseTruth, LeavesNoEvidenceOfWhatAMethodIsTooRoughFor) {
  const Case one = parse_cases("capsule-heap:two").front();
  const CaseTruth truth(one, dt, usual_budget);
  const EngineConfig ours = parse_engine("impulse");
  const CaseRun runs = run_case(one, ours, dt);
  const auto verdict_by = [&](const char* engine) {
    return judge_case(one, parse_engine(engine), dt, *runs.outcome.trace, runs.shifted, truth.reference()).verdict;
  };
  EXPECT_EQ(verdict_by("impulse"), Verdict::right);
  EXPECT_EQ(verdict_by("box2d"), Verdict::no_evidence);
}

}  // namespace
}  // namespace plumb::case_run_test
