#include "solver/local_sweeps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "column.h"

namespace impulse::inline IMPULSE_PRECISION::local_sweeps_test {
namespace {

/// Ten bodies of 1 kg above each other, and another beside them on the ground, which is of the last row.
struct Wall : Column {
  LocalSweeps local;

  Wall() : Column(std::vector<double>(11, 1)) { touch(10, 0, 11); }
  /// Whether sweeps may be local.
  bool find() { return local.find(island, ScalarContacts(bodies, motion), bodies.velocity.size(), real(.0001), false); }
  std::vector<std::uint32_t> found() { return {local.rows().begin(), local.rows().end()}; }
};

TEST(LocalSweeps, AreOfWhatGetsDeeperAndOfTwoBodiesRound) {
  Wall wall;
  wall.bodies.velocity[10].v.y = -1;
  ASSERT_TRUE(wall.find());
  EXPECT_THAT(wall.found(), testing::ElementsAre(7, 8, 9));
}

TEST(LocalSweeps, PassNothingOnThroughWhatCannotBePushed) {
  Wall wall;
  wall.bodies.velocity[11].v.y = -1;
  ASSERT_TRUE(wall.find());
  EXPECT_THAT(wall.found(), testing::ElementsAre(10));
  wall.bodies.velocity[11].v.y = 0;
  wall.bodies.velocity[1].v.y = -.5;
  wall.bodies.velocity[2].v.y = -.5;
  ASSERT_TRUE(wall.find());
  EXPECT_THAT(wall.found(), testing::ElementsAre(0, 1, 2));
}

TEST(LocalSweeps, AreNotWorthItWhereNothingOrMostGetsDeeper) {
  Wall wall;
  EXPECT_FALSE(wall.find());
  for (std::uint32_t i = 1; i < 12; ++i) wall.bodies.velocity[i].v.y = i % 4 == 0 ? -1 : 0;
  EXPECT_FALSE(wall.find());
}

TEST(LocalSweeps, LeaveOutContactsThatTakeNoPart) {
  Wall wall;
  wall.bodies.velocity[10].v.y = -1;
  std::erase(wall.acting, 8U);
  wall.island.acting = wall.acting;
  ASSERT_TRUE(wall.find());
  EXPECT_THAT(wall.found(), testing::ElementsAre(9));
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::local_sweeps_test
