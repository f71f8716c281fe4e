#include "reports/judge/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../fakes.h"

namespace plumb::verdict_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Expectation at_end(double expected, double tolerance) {
  return {.body = "box",
          .quantity = Quantity::x,
          .expected = expected,
          .allowed = [tolerance](const Stepping&) { return tolerance; },
          .source = "x0 + v t"};
}

// x ends at 1 + 3 * 2 = 7.
Judgement judge_end(double expected, double tolerance, double epsilon = 0) {
  const Scene scene = fakes::thrown_box();
  const std::vector<Expectation> expectations{at_end(expected, tolerance)};
  return judge(scene, expectations, fakes::flight_of(scene, 0.5), {.dt = 0.5, .h = 0.5, .epsilon = epsilon}, nullptr);
}

// The box moves by 6 m.
TEST(Judge, IsRightWithinAHundredthOfTheScaleCoarseWithinTheToleranceAndWrongOutside) {
  EXPECT_EQ(judge_end(7.06, 0.25).verdict, Verdict::right);
  EXPECT_EQ(judge_end(7.07, 0.25).verdict, Verdict::coarse);
  EXPECT_EQ(judge_end(7.25, 0.25).verdict, Verdict::coarse);
  EXPECT_EQ(judge_end(7.25, 0.2499).verdict, Verdict::wrong);
  const TruthCheck check = judge_end(7.25, 0.2499).checks.at(0);
  EXPECT_EQ(check.measured, 7);
  EXPECT_EQ(check.error, 0.25);
  EXPECT_EQ(check.tolerance, 0.2499);
  EXPECT_EQ(check.scale, 6.25) << "the way that it should have come";
  EXPECT_EQ(check.quantity, "x");
  EXPECT_EQ(check.unit, "m");
  EXPECT_EQ(check.time, 2);
  EXPECT_FALSE(check.passed);
}

// A mean over a sample is off by chance, which is no coarseness of an engine; but it must be within the tolerance.
TEST(Judge, GradesAMeanByWhatChanceDoesNotExplain) {
  const Scene scene = fakes::thrown_box();
  const auto judged = [&](double chance, double tolerance) {
    Expectation mean = at_end(7.25, tolerance);
    mean.chance = chance;
    return judge(scene, std::vector{mean}, fakes::flight_of(scene, 0.5), {.dt = 0.5, .h = 0.5}, nullptr);
  };
  EXPECT_EQ(judged(0.2, 0.25).verdict, Verdict::right);
  EXPECT_EQ(judged(0.18, 0.25).verdict, Verdict::coarse);
  EXPECT_EQ(judged(0.25, 0.2499).verdict, Verdict::wrong);
}

TEST(Judge, AddsNoRoundOffToAnAbsoluteTolerance) {
  const Scene scene = fakes::thrown_box();
  Expectation stated = at_end(7.25, 100);
  stated.within = 0.25;
  const auto judged = [&](double epsilon) {
    return judge(scene, std::vector{stated}, fakes::flight_of(scene, 0.5), {.dt = 0.5, .h = 0.5, .epsilon = epsilon},
                 nullptr);
  };
  EXPECT_EQ(judged(0.1).checks.at(0).tolerance, 0.25);  // no round-off on top
  EXPECT_EQ(judged(0).verdict, Verdict::coarse);
  stated.within = 0.2499;
  EXPECT_EQ(judged(0.1).verdict, Verdict::wrong);
}

TEST(Judge, NeverPassesAValueThatIsNotFinite) {
  EXPECT_EQ(judge_end(nan, 1).verdict, Verdict::wrong);
  EXPECT_EQ(judge_end(infinity, 1).verdict, Verdict::wrong);
  EXPECT_EQ(judge_end(7, nan).verdict, Verdict::wrong);
  EXPECT_EQ(judge_end(7, infinity).verdict, Verdict::wrong);
  EXPECT_EQ(judge_end(infinity, infinity).verdict, Verdict::wrong);

  const Scene scene = fakes::thrown_box();
  Trace trace(1);
  const BodyState lost{.position = {nan, 0}};
  trace.record(0, std::span(&lost, 1), {});
  trace.record(2, std::span(&lost, 1), {});
  const std::vector<Expectation> expectations{at_end(7, 1e9)};
  EXPECT_EQ(judge(scene, expectations, trace, {.dt = 2, .h = 2}, nullptr).verdict, Verdict::wrong);
}

TEST(Judge, NeverPassesAValueItCouldNotRead) {
  const Scene scene = fakes::thrown_box();
  Expectation late = at_end(7, 1e9);
  late.time = 3;
  Expectation second_apex = at_end(7, 1e9);
  second_apex.quantity = Quantity::apex;
  second_apex.index = 2;
  for (const Expectation& expectation : {late, second_apex}) {
    const auto judgement =
        judge(scene, std::span(&expectation, 1), fakes::flight_of(scene, 0.5), {.dt = 0.5, .h = 0.5}, nullptr);
    EXPECT_EQ(judgement.verdict, Verdict::wrong);
    EXPECT_TRUE(std::isnan(judgement.checks[0].measured));
    EXPECT_TRUE(std::isfinite(judgement.checks[0].time));
  }
}

TEST(Judge, HasNoEvidenceWhereEvenAWrongEngineWouldPass) {
  EXPECT_EQ(judge_end(7, 0.3).verdict, Verdict::right);
  EXPECT_EQ(judge_end(7, 0.31).verdict, Verdict::no_evidence) << "more than 5 % of 6 m";
}

TEST(Judge, TakesTheExpectedValueFromTheClosedForm) {
  const Scene scene = fakes::thrown_box();
  const Engine closed_form = fakes::free_flight();
  const Truth truth(closed_form, scene);
  const auto expectations = fakes::throwing().expectations({});
  const Stepping stepping{.dt = 0.5, .h = 0.5, .drift = 0.5};
  const auto judgement = judge(scene, expectations, fakes::flight_of(scene, 0.5), stepping, &truth);
  EXPECT_NE(judgement.verdict, Verdict::wrong);
  EXPECT_DOUBLE_EQ(judgement.checks[0].expected, 2 + 16 - 20);
  EXPECT_EQ(judge(scene, expectations, fakes::flight_of(scene, 0.5), stepping, nullptr).verdict, Verdict::wrong);
}

TEST(Judge, AllowsForTheRoundOffOfTheArithmetic) {
  EXPECT_EQ(judge_end(7 + 1e-6, 0).verdict, Verdict::wrong);
  EXPECT_EQ(judge_end(7 + 1e-6, 0, std::numeric_limits<float>::epsilon()).verdict, Verdict::right);
  EXPECT_EQ(judge_end(7 + 1e-3, 0, std::numeric_limits<float>::epsilon()).verdict, Verdict::wrong);
}

// The measured value is 7.
TEST(Judge, AppliesABoundOnOneSideOnly) {
  const Scene scene = fakes::thrown_box();
  const auto judged = [&](Relation relation, double expected, double tolerance) {
    Expectation one = at_end(expected, tolerance);
    one.relation = relation;
    return judge(scene, std::span(&one, 1), fakes::flight_of(scene, 0.5), {.dt = 0.5, .h = 0.5}, nullptr);
  };
  EXPECT_EQ(judged(Relation::at_least, 2, 0).verdict, Verdict::no_evidence) << "many other motions are above it, too";
  EXPECT_EQ(judged(Relation::at_least, 7.25, 0.25).verdict, Verdict::coarse);
  EXPECT_EQ(judged(Relation::at_least, 7.25, 0.2).verdict, Verdict::wrong);
  // A box that never moved would be below these as well.
  EXPECT_EQ(judged(Relation::at_most, 20, 0).verdict, Verdict::plausible);
  EXPECT_EQ(judged(Relation::at_most, 6.75, 0.25).verdict, Verdict::plausible);
  EXPECT_EQ(judged(Relation::at_most, 6.75, 0.2).verdict, Verdict::wrong);
  EXPECT_EQ(judged(Relation::at_least, 2, 0).checks[0].error, 0);
  EXPECT_EQ(judged(Relation::at_most, 6.75, 0.2).checks[0].error, 0.25);
  for (const double none : {nan, infinity, -infinity}) {
    EXPECT_EQ(judged(Relation::at_least, none, 1).verdict, Verdict::wrong);
    EXPECT_EQ(judged(Relation::at_most, none, 1).verdict, Verdict::wrong);
  }
}

TEST(Judge, HasNoEvidenceOfAQuantityThatIsNotReported) {
  const Scene scene = fakes::thrown_box();
  const Expectation load{.body = "box",
                         .quantity = Quantity::load,
                         .over = 2,
                         .expected = 20,
                         .allowed = [](const Stepping&) { return 1.0; },
                         .source = "m g"};
  const auto verdict = [&](std::vector<Expectation> all) {
    return judge(scene, all, fakes::flight_of(scene, 0.5), {.dt = 0.5, .h = 0.5}, nullptr).verdict;
  };
  EXPECT_EQ(verdict({load}), Verdict::no_evidence);
  EXPECT_EQ(verdict({load, at_end(7, 0.1)}), Verdict::no_evidence);
  EXPECT_EQ(verdict({load, at_end(8, 0.1)}), Verdict::wrong);
}

// A thrown box without gravity keeps its energy, as does one that hangs where it was thrown.
TEST(Judge, LearnsNothingOfAMotionFromWhatAMotionlessSceneKeeps) {
  Scene scene = fakes::thrown_box();
  scene.gravity = {};
  const Expectation energy{.quantity = Quantity::energy,
                           .expected = quantity_of(Quantity::energy, 0, Conserved(scene), initial_states(scene)),
                           .allowed = [](const Stepping&) { return 1e-9; }};
  const auto judged = [&](const Scene& of, std::vector<Expectation> all) {
    return judge(of, all, fakes::flight_of(of, 0.5), {.dt = 0.5, .h = 0.5}, nullptr);
  };
  EXPECT_TRUE(judged(scene, {energy}).checks[0].idle);
  EXPECT_NE(judged(scene, {energy}).verdict, Verdict::right);
  EXPECT_FALSE(judged(scene, {energy, at_end(7, 0.1)}).checks[1].idle);
  EXPECT_EQ(judged(scene, {energy, at_end(7, 0.1)}).verdict, Verdict::right);

  scene.bodies[0].velocity = {};
  scene.bodies[0].angular_velocity = 0;
  const Judgement resting = judged(scene, {at_end(1, 0.01)});
  EXPECT_FALSE(resting.checks[0].idle);
  EXPECT_EQ(resting.verdict, Verdict::right) << "where nothing should move, staying is the motion";
}

TEST(VerdictOf, NeedsEvidenceOfTheMotionToBeRight) {
  const TruthCheck kept{.quantity = "energy", .tolerance = 0.01, .scale = 1, .passed = true, .idle = true};
  const TruthCheck place{.quantity = "x", .tolerance = 0.01, .scale = 1, .passed = true};
  const TruthCheck vague{.quantity = "x", .tolerance = 0.1, .scale = 1, .passed = true};
  EXPECT_EQ(verdict_of(std::vector{kept, place}, {}), Verdict::right);
  EXPECT_EQ(verdict_of(std::vector{kept, vague}, {}), Verdict::no_evidence);
  EXPECT_EQ(verdict_of(std::vector{kept}, {}), Verdict::no_evidence);
  const std::vector<InvariantCheck> tested{{.status = CheckStatus::held, .scale = 1}};
  EXPECT_EQ(verdict_of(std::vector{kept}, tested), Verdict::plausible);
  EXPECT_EQ(verdict_of(std::vector{kept, vague}, tested), Verdict::no_evidence);
}

TEST(VerdictOf, IsWrongIfAnInvariantIsBrokenWhateverTheTruthSays) {
  const std::vector<TruthCheck> passed{{.quantity = "x", .scale = 1, .passed = true}};
  const std::vector<InvariantCheck> held{{.status = CheckStatus::held, .scale = 1},
                                         {.status = CheckStatus::not_reported}};
  const std::vector<InvariantCheck> broken{{.status = CheckStatus::held}, {.status = CheckStatus::broken}};
  EXPECT_EQ(verdict_of(passed, held), Verdict::right);
  EXPECT_EQ(verdict_of(passed, broken), Verdict::wrong);
  EXPECT_EQ(verdict_of({}, held), Verdict::plausible);
  EXPECT_EQ(verdict_of({}, broken), Verdict::wrong);
}

TEST(VerdictOf, IsPlausibleOnlyIfAnInvariantWasTested) {
  const std::vector<InvariantCheck> idle{{.status = CheckStatus::held, .tolerance = 0.1},
                                         {.status = CheckStatus::not_reported, .scale = 1},
                                         {.status = CheckStatus::held, .tolerance = 0.1, .scale = 1}};
  EXPECT_EQ(verdict_of({}, idle), Verdict::no_evidence);
  EXPECT_EQ(verdict_of({}, {}), Verdict::no_evidence);
}

// What is known of a quantity before something happens says nothing about what that does to it.
TEST(VerdictOf, AsksForEvidenceAtTheTimeOfTheQuestionOrLater) {
  const TruthCheck before{.quantity = "energy", .time = 0.1, .tolerance = 0.01, .scale = 1, .passed = true};
  const TruthCheck vague{.quantity = "energy", .time = 1, .tolerance = 0.1, .scale = 1, .passed = true};
  TruthCheck after = before;
  after.time = 1;
  EXPECT_EQ(verdict_of(std::vector{before}, {}), Verdict::right);
  EXPECT_EQ(verdict_of(std::vector{before, vague}, {}), Verdict::no_evidence);
  EXPECT_EQ(verdict_of(std::vector{vague, after}, {}), Verdict::right);
}

TEST(VerdictOf, AsksForEvidenceOfEveryQuantity) {
  const TruthCheck x{.quantity = "x", .tolerance = 0.01, .scale = 1, .passed = true};
  const TruthCheck y{.quantity = "y", .tolerance = 0.5, .scale = 1, .passed = true};
  const TruthCheck angle{.quantity = "angle", .tolerance = 0.5, .scale = 1, .passed = true};
  EXPECT_EQ(verdict_of(std::vector{x, y}, {}), Verdict::right) << "one place";
  EXPECT_EQ(verdict_of(std::vector{x, angle}, {}), Verdict::no_evidence);
}

}  // namespace
}  // namespace plumb::verdict_test
