#include <gtest/gtest.h>

#include "bracket.h"

namespace plumb {
namespace {

TEST(StackMap, GrowsWithWork) {
  const auto highest = [](const char* engine) { return *bracket("stack", engine, 0, 1, 30, "stands").low; };
  EXPECT_LT(highest("box2d:velocity=2"), highest("box2d:velocity=16"));
}

}  // namespace
}  // namespace plumb
