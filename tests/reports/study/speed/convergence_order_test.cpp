#include "reports/study/speed/convergence_order.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace plumb::convergence_order_test {
namespace {

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

}  // namespace
}  // namespace plumb::convergence_order_test
