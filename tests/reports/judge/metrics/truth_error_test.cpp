#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb::truth_error_test {
namespace {

Trace line(std::initializer_list<double> xs, double angle) {
  Trace trace(1);
  for (const double x : xs) {
    const BodyState state{.position = {x, 0}, .angle = angle};
    trace.record(static_cast<double>(trace.size()), std::span(&state, 1), {});
  }
  return trace;
}

TEST(TruthError, IsTheLargestTheRmsAndTheLast) {
  const Scene scene{.bodies = {{.name = "box"}}};
  const Trace trace = line({0, 1, 2, 3}, 0.25);
  const Trace truth = line({0, 4, 2, 3.5}, 0);
  const MetricContext context{.scene = scene, .trace = trace, .truth = &truth, .truth_until = 9};
  EXPECT_DOUBLE_EQ(*measured("truth_error_max", context), 3);
  EXPECT_DOUBLE_EQ(*measured("truth_error_rms", context), std::sqrt((9 + 0.25) / 4));
  EXPECT_DOUBLE_EQ(*measured("truth_error_end", context), 0.5);
  EXPECT_DOUBLE_EQ(*measured("truth_angle_error_max", context), 0.25);
}

TEST(TruthError, CountsOnlyWhileTheTruthIsValid) {
  const Scene scene{.bodies = {{.name = "box"}}};
  const Trace trace = line({0, 1, 2, 3}, 0);
  const Trace truth = line({0, 2, 9, 9}, 0);
  const MetricContext context{.scene = scene, .trace = trace, .truth = &truth, .truth_until = 1.5};
  EXPECT_DOUBLE_EQ(*measured("truth_error_max", context), 1);
  EXPECT_DOUBLE_EQ(*measured("truth_error_end", context), 1);
}

}  // namespace
}  // namespace plumb::truth_error_test
