#include <gtest/gtest.h>

#include "bracket.h"

namespace plumb::stacks_test {
namespace {

TEST(ArchMap, FallsWhereNoLineOfThrustFits) {
  const Bracket found = bracket("arch", "impulse", 0, 0.12, 0.09, "stands");
  EXPECT_EQ(found.outcome.mode, FailureMode::topples);
  EXPECT_GT(*found.low, *found.high) << "thick stones stand";
}

TEST(StackMap, HoldsMoreBoxesWithMoreWork) {
  const auto highest = [](const char* engine) { return *bracket("stack", engine, 0, 1, 30, "stands").low; };
  EXPECT_LT(highest("box2d:velocity=2"), highest("box2d:velocity=16"));
}

}  // namespace
}  // namespace plumb::stacks_test
