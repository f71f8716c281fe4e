#include "reports/study/statistics/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "scenarios/random.h"

namespace plumb::interval_test {
namespace {

// Tables: E. S. Pearson, H. O. Hartley, Biometrika Tables for Statisticians, 1966.
TEST(StudentT, HasTheQuantilesOfTheTables) {
  EXPECT_NEAR(student_quantile(0.975, 10), 2.2281, 5e-5);
  EXPECT_NEAR(student_quantile(0.995, 4), 4.6041, 5e-5);
  EXPECT_NEAR(student_quantile(0.9995, 1), 636.62, 5e-3);
  EXPECT_NEAR(student_quantile(0.025, 30), -2.0423, 5e-5);
  EXPECT_NEAR(student_quantile(0.975, 1e6), 1.95996, 1e-5) << "normal in the limit";
}

TEST(ChiSquare, HasTheQuantilesOfTheTables) {
  EXPECT_NEAR(chi_square_quantile(0.95, 10), 18.3070, 5e-5);
  EXPECT_NEAR(chi_square_quantile(0.999, 3), 16.2662, 5e-5);
  EXPECT_NEAR(chi_square_quantile(0.05, 20), 10.8508, 5e-5);
  EXPECT_NEAR(chi_square_share(2 * std::log(2), 2), 0.5, 1e-12) << "exponential for two degrees of freedom";
}

TEST(MeanInterval, TakesTwoValues) {
  EXPECT_THROW(mean_interval(std::vector<double>{1}, 0.05), std::invalid_argument);
  const Estimate found = mean_interval(std::vector<double>{1, 3}, 0.05);
  EXPECT_EQ(found.value, 2);
  EXPECT_EQ(found.error, 1);
  EXPECT_NEAR(found.high, 2 + 12.706, 1e-3);
}

// 2000 samples of six sums of twelve uniform values, normal to a per mille: 100 +- 4 * 9.7 of their intervals miss.
TEST(MeanInterval, MissesTheMeanAsOftenAsItSays) {
  Random random(1);
  int missed = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    std::vector<double> values(6, -6);
    for (double& value : values) {
      for (int i = 0; i < 12; ++i) value += random.between(0, 1);
    }
    const Estimate found = mean_interval(values, 0.05);
    missed += found.low > 0 || found.high < 0;
  }
  EXPECT_NEAR(missed, 100, 39);
}

}  // namespace
}  // namespace plumb::interval_test
