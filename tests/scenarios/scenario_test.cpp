#include "scenarios/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace plumb::scenario_test {
namespace {

using testing::HasSubstr;

const Scenario family{.name = "tower",
                      .parameters = {{.name = "height", .value = 2, .min = 1, .max = 5, .unit = "m"},
                                     {.name = "boxes", .value = 3, .min = 1, .max = 10, .whole = true}}};

std::string refusal(const Parameters& changes) {
  try {
    complete(family, changes);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Complete, AppliesChangesToTheDefaults) {
  EXPECT_EQ(complete(family, {}), (Parameters{{"boxes", 3}, {"height", 2}}));
  EXPECT_EQ(complete(family, {{"height", 5}}), (Parameters{{"boxes", 3}, {"height", 5}}));
}

TEST(Complete, RefusesUnknownNamesAndSuggestsTheNearest) {
  EXPECT_EQ(refusal({{"hieght", 2}}), "tower: unknown parameter \"hieght\", did you mean \"height\"?");
}

TEST(Complete, RefusesValuesOutOfRangeAndSaysTheRange) {
  EXPECT_EQ(refusal({{"height", 7}}), "tower: height = 7 is out of range, must be 1 ... 5 m");
  EXPECT_THAT(refusal({{"height", std::numeric_limits<double>::quiet_NaN()}}), HasSubstr("out of range"));
}

TEST(Complete, RefusesFractionsOfWholeNumbers) {
  EXPECT_EQ(refusal({{"boxes", 2.5}}), "tower: boxes = 2.5 must be a whole number");
}

TEST(Relation, HasANameInWords) {
  EXPECT_STREQ(name_of(Relation::equal), "equal");
  EXPECT_STREQ(name_of(Relation::at_least), "at least");
  EXPECT_STREQ(name_of(Relation::at_most), "at most");
}

}  // namespace
}  // namespace plumb::scenario_test
