#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "reports/study/speed/work_precision.h"

namespace plumb::work_precision_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ConvergenceOrder, IsTheExactSlopeOfAPowerLaw) {
  const std::vector<double> steps{0.1, 0.05, 0.025, 0.0125};
  std::vector<double> errors;
  for (const double h : steps) errors.push_back(3 * std::pow(h, 4));
  const auto order = order_of(steps, errors);
  ASSERT_TRUE(order);
  EXPECT_NEAR(order->slope, 4, 1e-12);
  EXPECT_NEAR(order->half_width, 0, 1e-6);
  EXPECT_EQ(order->points, 4);
  EXPECT_FALSE(order_of(std::span(steps).first(2), std::span(errors).first(2)));
}

// y = 1, 2, 2 at x = 0, 1, 2: slope 1/2, sum of squares 1/6 with one degree of freedom: t = 12.706, sqrt(1/6 / 1 / 2).
TEST(ConvergenceOrder, HasStudentsConfidenceInterval) {
  const std::vector<double> steps{1, std::exp(1), std::exp(2)};
  const std::vector<double> errors{std::exp(1), std::exp(2), std::exp(2)};
  const auto order = order_of(steps, errors);
  EXPECT_NEAR(order->slope, 0.5, 1e-12);
  EXPECT_NEAR(order->half_width, 12.706 * std::sqrt(1.0 / 12), 1e-9);
}

TEST(SettledOrder, LeavesOutStepsThatAreTooLarge) {
  const std::vector<double> steps{1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480};
  std::vector<double> errors;
  for (const double h : steps) errors.push_back(std::exp(60 * h) - 1);  // first order, once 60 h is small
  EXPECT_GT(order_of(steps, errors)->slope, 1.2);
  const auto settled = settled_order(steps, errors);
  ASSERT_TRUE(settled);
  EXPECT_EQ(settled->points, 3);
  EXPECT_NEAR(settled->slope, 1.14, 0.01);
}

TEST(SettledOrder, IsMissingIfErrorsAreIrregular) {
  const std::vector<double> steps{0.1, 0.05, 0.025, 0.0125};
  EXPECT_FALSE(settled_order(steps, std::vector<double>{4, 2, 2, 0.5}));
  EXPECT_FALSE(settled_order({}, {}));
  EXPECT_FALSE(settled_order(std::span(steps).first(1), std::vector<double>{1}));
}

TEST(ParetoFront, HasThePointsThatNoOtherBeats) {
  const std::vector<WorkPoint> points{{4, 1}, {1, 8}, {2, 9}, {2, 4}, {1, 8}, {3, 4}, {5, 1}};
  EXPECT_THAT(pareto_front(points), ElementsAre(1, 3, 0));
  EXPECT_THAT(pareto_front({}), IsEmpty());
}

const std::vector<WorkPoint> front{{1, 1e-1}, {10, 1e-3}, {100, 1e-4}};

TEST(TimeToReach, FollowsAPowerLawBetweenRuns) {
  const auto found = time_to_reach(front, 1e-2);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, std::sqrt(10.0), 1e-12);
  EXPECT_FALSE(found->bound);
  EXPECT_DOUBLE_EQ(time_to_reach(front, 1e-3)->value, 10);
  EXPECT_FALSE(time_to_reach(front, 1e-1)->bound) << "the error of the cheapest run";
}

TEST(TimeToReach, DoesNotExtrapolate) {
  EXPECT_FALSE(time_to_reach(front, 0.99e-4));
  EXPECT_FALSE(time_to_reach({}, 1));
  const auto easy = time_to_reach(front, 1);
  EXPECT_EQ(easy->value, 1);
  EXPECT_TRUE(easy->bound);
}

TEST(ErrorWithin, FollowsAPowerLawBetweenRunsAndDoesNotExtrapolate) {
  EXPECT_NEAR(error_within(front, std::sqrt(10.0))->value, 1e-2, 1e-14);
  EXPECT_DOUBLE_EQ(error_within(front, 10)->value, 1e-3);
  EXPECT_FALSE(error_within(front, 0.99));
  EXPECT_FALSE(error_within({}, 1));
  EXPECT_DOUBLE_EQ(error_within(front, 1000)->value, 1e-4);
  EXPECT_TRUE(error_within(front, 1000)->bound);
  EXPECT_FALSE(error_within(front, 100)->bound);
}

}  // namespace
}  // namespace plumb::work_precision_test
