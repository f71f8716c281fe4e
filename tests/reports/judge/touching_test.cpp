#include "reports/judge/touching.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

constexpr double slack = 1e-9;  // m

TEST(TouchingPairs, GatherTheirPointsWhicheverBodyIsCalledA) {
  const std::vector<ContactState> contacts{
      {.a = 0, .b = 2, .normal = {0, 1}, .normal_impulse = 1, .tangent_impulse = 0.5, .separation = 0.25},
      {.a = 2, .b = 0, .normal = {0, -1}, .normal_impulse = 2, .tangent_impulse = 0.25, .separation = -0.5},
      {.a = 1, .b = 2, .separation = 1}};
  const TouchingPairs pairs = touching_pairs(contacts);
  ASSERT_EQ(pairs.size(), 2u);
  const Touching& both = pairs.at({0, 2});
  EXPECT_EQ(both.points.size(), 2u);
  EXPECT_EQ(both.push, 3);
  EXPECT_EQ(both.rub, 0.75);
  EXPECT_EQ(both.separation(), -0.5);
  EXPECT_EQ(both.points[1].normal, (Vec{0, 1}));
}

TEST(TouchingPairs, ActWhereTheyPushOrOverlap) {
  const auto acts = [](double impulse, double separation) {
    const std::vector<ContactState> one{{.a = 0, .b = 1, .normal_impulse = impulse, .separation = separation}};
    return touching_pairs(one).at({0, 1}).acts(slack);
  };
  EXPECT_TRUE(acts(1, 0.25));
  EXPECT_TRUE(acts(0, -1e-6));
  EXPECT_FALSE(acts(0, 0.25));
  EXPECT_FALSE(acts(0, -1e-12)) << "round-off";
}

}  // namespace
}  // namespace plumb
