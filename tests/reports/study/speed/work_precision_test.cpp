#include "reports/study/speed/work_precision.h"

#include <gmock/gmock.h>

#include <cmath>

namespace plumb::work_precision_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

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
