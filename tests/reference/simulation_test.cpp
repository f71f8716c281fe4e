#include "reference/simulation.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace plumb::simulation_test {
namespace {

const Engine engine{
    .name = "engine",
    .options = {{.key = "iterations", .value = "8", .min = 1, .max = 100},
                {.key = "solver", .value = "plain", .choices = {{"plain", "as printed"}, {"soft", "with springs"}}}}};

std::string complaint(const Settings& given) {
  try {
    complete(engine, given);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CompleteSettings, FillInWhatIsMissing) {
  EXPECT_EQ(complete(engine, {{"solver", "soft"}}), (Settings{{"iterations", "8"}, {"solver", "soft"}}));
}

TEST(CompleteSettings, RefuseUnknownKeysAndChoicesNamingTheNearest) {
  EXPECT_EQ(complaint({{"iteration", "3"}}), "engine: unknown option \"iteration\", did you mean \"iterations\"?");
  EXPECT_EQ(complaint({{"solver", "sotf"}}), "engine: option solver: unknown choice \"sotf\", did you mean \"soft\"?");
}

TEST(CompleteSettings, RefuseNumbersThatAreMalformedOrOutOfRange) {
  for (const char* value : {"", "many", "8x", "0", "101", "nan", "inf"}) {
    EXPECT_EQ(complaint({{"iterations", value}}),
              "engine: option iterations: \"" + std::string(value) + "\" must be a number, 1 ... 100");
  }
}

TEST(CompleteSettings, RefuseFractionsWhereWholeNumbersAreNeeded) {
  const Engine counting{.name = "counting", .options = {{.key = "n", .value = "8", .max = 9, .whole = true}}};
  EXPECT_EQ(complete(counting, {{"n", "7"}}).at("n"), "7");
  try {
    complete(counting, {{"n", "7.5"}});
    FAIL() << "took half an iteration";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "counting: option n: \"7.5\" must be a whole number, 0 ... 9");
  }
}

TEST(Simulation, IsValidForEverByDefault) {
  class Still : public Simulation {
    void step(double) override {}
    void read(std::span<BodyState>) const override {}
  };
  EXPECT_EQ(Still{}.valid_until(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace plumb::simulation_test
