#include "reports/run/case_truth.h"

#include <gmock/gmock.h>

#include <cmath>

#include "reports/run/selection.h"

namespace plumb::case_truth_test {
namespace {

using ::testing::IsNull;
using ::testing::NotNull;

constexpr double dt = 1.0 / 60;

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
}  // namespace plumb::case_truth_test
