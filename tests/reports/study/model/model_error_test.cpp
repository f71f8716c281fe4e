#include "reports/study/model/model_error.h"

#include <gmock/gmock.h>

#include <cmath>

#include "reports/run/selection.h"

namespace plumb::model_error_test {
namespace {

constexpr double time_step = 1.0 / 60;

struct ErrorsIn : ModelError {
  explicit ErrorsIn(const std::string& word, double tolerance = 1e-4)
      : ModelError(parse_case(word), parse_engine("impulse"), time_step, tolerance) {
    find();
  }
};

TEST(ModelError, IsZeroForTheFullModel) {
  for (const char* word : {"spring:w=4", "bounce:e=0.8", "rain:count=8", "free-bodies:side=3"}) {
    const ErrorsIn errors(word);
    const ModelError::Result result = errors.of(errors.full());
    EXPECT_EQ(result.change, 0) << word;
    EXPECT_TRUE(errors.within_tolerance(result)) << word;
  }
}

// Second order with sub-steps four times as long: sixteen times the error.
TEST(ModelError, IsMeasuredAgainstTheReferenceSolution) {
  const ErrorsIn errors("spring:w=4");
  EXPECT_EQ(errors.truth(), "spring");
  EXPECT_EQ(errors.compared_until(), 0);
  const double full = errors.of(errors.full()).error;
  const ModelError::Result coarse = errors.of(parse_engine("impulse:substeps=1"));
  EXPECT_NEAR(coarse.error / full, 16, 0.5);
  EXPECT_DOUBLE_EQ(coarse.change, coarse.error - full);
  EXPECT_FALSE(errors.within_tolerance(coarse));
  EXPECT_LE(errors.of(parse_engine("impulse:substeps=8")).change, 0);
}

// Boxes and discs that spin in free flight: only angles differ.
TEST(ModelError, ConvertsAnglesToDisplacements) {
  const ErrorsIn errors("free-bodies:side=3");
  const double change = errors.of(parse_engine("impulse:rotation=off")).change;
  // 3 rad/s for 1 s: the RMS over time is 3/sqrt(3) rad, at the radius of gyration of a disc of 1/4 m.
  EXPECT_NEAR(change, std::sqrt(3.0) * 0.25 / std::sqrt(2.0), 0.02);
}

TEST(ModelError, ComparesWithTheFullModelIfTheReferenceSolutionEnds) {
  const ErrorsIn errors("smash");
  EXPECT_GT(errors.compared_until(), errors.truth_until());
  const ModelError::Result passing = errors.of(parse_engine("impulse:contacts=off"));
  EXPECT_GT(passing.change, 1e-2);
  EXPECT_FALSE(errors.within_tolerance(passing));
}

// No two methods move alike in a heap: what counts is how high it is, what energy it has and when it rests.
TEST(ModelError, JudgesChaoticScenesByStatistics) {
  const ErrorsIn errors("rain:count=50,seed=2");
  ASSERT_TRUE(errors.chaotic());
  const ModelError::Result other = errors.of(parse_engine("impulse:substeps=2"));
  EXPECT_GT(other.change, 1e-4) << "single motions differ";
  EXPECT_TRUE(errors.within_tolerance(other)) << other.different << other.breaks;
  const ModelError::Result falling = errors.of(parse_engine("impulse:contacts=off"));
  EXPECT_NE(falling.different, "");
  EXPECT_FALSE(errors.within_tolerance(falling));
  EXPECT_FALSE(ErrorsIn("spring:w=4").chaotic());
}

// A heap may have the same statistics with bodies deep in each other.
TEST(ModelError, CountsOverlapsAndBrokenLawsInChaoticScenes) {
  const ErrorsIn errors("rain:count=50");
  ASSERT_TRUE(errors.chaotic());
  const ModelError::Result deep =
      errors.of(parse_engine("impulse:solver=sequential-impulse,integrator=velocity-verlet"));
  EXPECT_THAT(deep.different, testing::HasSubstr("overlap 0.1"));
  EXPECT_THAT(deep.breaks, testing::HasSubstr("cone of "));
  EXPECT_FALSE(errors.within_tolerance(deep));
  const ModelError::Result full = errors.of(errors.full());
  EXPECT_EQ(full.different + full.breaks, "");
}

TEST(ModelError, SaysWhyAModelDidNotRun) {
  const ErrorsIn errors("hanging-chain:still");
  const ModelError::Result result = errors.of(parse_engine("impulse:solver=exact"));
  EXPECT_NE(result.status, Status::ok);
  EXPECT_NE(result.reason, "");
  EXPECT_TRUE(std::isinf(result.change));
  EXPECT_FALSE(errors.within_tolerance(result));
}

}  // namespace
}  // namespace plumb::model_error_test
