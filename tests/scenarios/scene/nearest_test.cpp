#include "scenarios/scene/nearest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace plumb::nearest_test {
namespace {

const std::vector<std::string> names{"height", "radius", "restitution"};

TEST(Nearest, FindsTheNameWithTheFewestEdits) {
  EXPECT_EQ(nearest("hieght", names), "height");
  EXPECT_EQ(nearest("restituton", names), "restitution");
  EXPECT_EQ(nearest("radios", names), "radius");
}

TEST(Nearest, IgnoresCase) { EXPECT_EQ(nearest("RADIUS", names), "radius"); }

TEST(Nearest, ReturnsTheFirstOfEquallyCloseNames) {
  EXPECT_EQ(nearest("xx", std::vector<std::string>{"ab", "cd"}), "ab");
}

TEST(Nearest, SuggestsNothingWithoutNames) {
  EXPECT_EQ(nearest("height", {}), "");
  EXPECT_EQ(unknown("parameter", "height", {}), "unknown parameter \"height\"");
}

TEST(Unknown, SuggestsTheNearestName) {
  EXPECT_EQ(unknown("parameter", "hieght", names), "unknown parameter \"hieght\", did you mean \"height\"?");
  EXPECT_EQ(unknown("parameter", "rest", names), "unknown parameter \"rest\", did you mean \"restitution\"?");
}

TEST(Unknown, ListsAFewNamesWhereNoneResemblesTheWord) {
  EXPECT_EQ(unknown("key", "lowerAngle", names),
            "unknown key \"lowerAngle\", expected one of: height, radius, restitution");
  EXPECT_EQ(unknown("key", "lowerAngle", std::vector<std::string>(13, "type")), "unknown key \"lowerAngle\"");
}

}  // namespace
}  // namespace plumb::nearest_test
