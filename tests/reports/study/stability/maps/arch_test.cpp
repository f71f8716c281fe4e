#include <gtest/gtest.h>

#include "bracket.h"

namespace plumb {
namespace {

TEST(ArchMap, FallsWhereNoLineOfThrustIsLeft) {
  const Bracket found = bracket("arch", "impulse", 0, 0.12, 0.09, "stands");
  EXPECT_EQ(found.seen.fate, Fate::topples);
  EXPECT_GT(*found.low, *found.high) << "thick stones stand";
}

}  // namespace
}  // namespace plumb
