#include "reports/statistics.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Quartiles, InterpolateBetweenOrderStatistics) {
  const Quartiles all = quartiles({4, 1, 3, 2});
  EXPECT_EQ(all.low, 1.75);
  EXPECT_EQ(all.median, 2.5);
  EXPECT_EQ(all.high, 3.25);
}

TEST(Quartiles, OfOneAreThatOneAndOfNothingZero) {
  EXPECT_EQ(quartiles({7}).low, 7);
  EXPECT_EQ(quartiles({7}).high, 7);
  EXPECT_EQ(quartiles({}).median, 0);
}

}  // namespace
}  // namespace plumb
