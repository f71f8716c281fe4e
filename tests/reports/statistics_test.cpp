#include "reports/statistics.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace plumb::statistics_test {
namespace {

using ::testing::ElementsAre;
using Values = std::vector<double>;

TEST(Quartiles, InterpolateBetweenOrderStatistics) {
  const Quartiles all = quartiles({4, 1, 3, 2});
  EXPECT_EQ(all.low, 1.75);
  EXPECT_EQ(all.median, 2.5);
  EXPECT_EQ(all.high, 3.25);
}

TEST(Quartiles, OfOneValueAreThatValueAndOfNoneZero) {
  EXPECT_EQ(quartiles({7}).low, 7);
  EXPECT_EQ(quartiles({7}).high, 7);
  EXPECT_EQ(quartiles({}).median, 0);
}

TEST(RankTest, CountsEveryArrangementOfSmallSamples) {
  // Three below three: one arrangement of 6!/(3! 3!) = 20 on either side.
  const RankTest apart = rank_test(Values{1, 2, 3}, Values{4, 5, 6});
  EXPECT_DOUBLE_EQ(apart.p, 2.0 / 20);
  EXPECT_DOUBLE_EQ(apart.effect, -1);
  // U = 2 of 9: arrangements with U = 0, 1, 2 number 1 + 1 + 2.
  EXPECT_DOUBLE_EQ(rank_test(Values{1, 2, 5}, Values{3, 4, 6}).p, 8.0 / 20);
}

// From the table of critical values at 5 % for 10 and 10: U <= 23 (Mann and Whitney, 1947; here 23: .0433, 24: .0524).
TEST(RankTest, AgreesWithTheTableOfCriticalValues) {
  const auto with_u = [](int u) {
    Values a, b;
    for (int i = 0; i < 10; ++i) b.push_back(i);
    // Each a exceeds as many b's as it still needs of u.
    for (int i = 0; i < 10; ++i) {
      const int above = std::min(u, 10);
      a.push_back(above - 0.5 - 0.001 * (10 - i));
      u -= above;
    }
    return rank_test(a, b).p;
  };
  EXPECT_NEAR(with_u(23), 0.0433, 5e-5);
  EXPECT_NEAR(with_u(24), 0.0524, 5e-5);
}

// Two neighbouring values within one sample are made equal, so that the order between the samples stays.
TEST(RankTest, TheApproximationMatchesTheExactTestWhereItTakesOver) {
  Values a, b;
  for (int i = 0; i < 20; ++i) a.push_back(i);
  for (int i = 0; i < 10; ++i) b.insert(b.end(), {i + 4.5, i + 14.5});
  const RankTest exact = rank_test(a, b);
  ASSERT_EQ(b.back(), 23.5);
  *std::find(b.begin(), b.end(), 22.5) = 23.5;
  EXPECT_LT(exact.p, 0.05);
  EXPECT_NEAR(std::log(rank_test(a, b).p), std::log(exact.p), 0.1);
}

TEST(RankTest, FindsNoDifferenceIfAllValuesAreEqual) {
  const RankTest same = rank_test(Values{2, 2, 2}, Values{2, 2, 2, 2});
  EXPECT_EQ(same.p, 1);
  EXPECT_EQ(same.effect, 0);
}

TEST(RankTest, RefusesEmptySamplesAndNaN) {
  EXPECT_THROW(rank_test(Values{}, Values{1}), std::invalid_argument);
  EXPECT_THROW(rank_test(Values{1}, Values{std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

// Each at its share of the level, from the smallest p on, until one is not significant.
TEST(Significant, StepsDownAsHolmDoes) {
  EXPECT_THAT(significant(Values{0.02, 0.01, 0.2}, 0.05), ElementsAre(true, true, false));
  EXPECT_THAT(significant(Values{0.03, 0.02, 0.2}, 0.05), ElementsAre(false, false, false));
  EXPECT_THAT(significant(Values{}, 0.05), ElementsAre());
}

}  // namespace
}  // namespace plumb::statistics_test
