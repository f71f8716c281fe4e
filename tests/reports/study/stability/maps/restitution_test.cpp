#include <gtest/gtest.h>

#include "bracket.h"

namespace plumb {
namespace {

TEST(RestitutionMap, SeesWhatBouncesTooHigh) {
  const Bracket found = bracket("restitution", "impulse:solver=article", 0.8, 1.0 / 240, 0.1, "bounces");
  EXPECT_EQ(found.seen.fate, Fate::gains_energy);
  EXPECT_EQ(found.seen.body, "disc");
}

}  // namespace
}  // namespace plumb
