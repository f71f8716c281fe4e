#include "reports/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb::report_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ErrorRatio, IsErrorOverTolerance) {
  EXPECT_EQ(error_ratio(1, 4), 0.25);
  EXPECT_EQ(error_ratio(0, 0), 0);
  EXPECT_EQ(error_ratio(-1, 4), 0);
}

TEST(ErrorRatio, NeverPassesAValueThatIsNotFinite) {
  EXPECT_EQ(error_ratio(std::nan(""), 1), infinity);
  EXPECT_EQ(error_ratio(1, infinity), infinity);
  EXPECT_EQ(error_ratio(1, 0), infinity);
}

TEST(WorstErrorRatio, SkipsChecksThatAreNotReported) {
  RunRecord run;
  EXPECT_FALSE(worst_error_ratio(run));
  run.truth = {{.error = 1, .tolerance = 2}, {.error = 9, .tolerance = 2, .reported = false}};
  EXPECT_EQ(worst_error_ratio(run), 0.5);
  run.invariants = {{.ratio = 0.75}, {.status = CheckStatus::not_reported, .ratio = 3}};
  EXPECT_EQ(worst_error_ratio(run), 0.75);
}

}  // namespace
}  // namespace plumb::report_test
