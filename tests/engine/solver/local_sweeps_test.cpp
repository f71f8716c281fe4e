#include "solver/local_sweeps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::local_sweeps_test {
namespace {

/// Ten bodies of 1 kg above each other, the lowest on body 0, which is fixed, and another beside them on it. Row i is
/// of the bodies i and i + 1, and the last of the fixed one and that beside them.
struct Column {
  BodySet bodies;
  std::vector<std::uint32_t> members{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  std::vector<ImpactRow> rows = std::vector<ImpactRow>(11);
  std::vector<Motion> motion = std::vector<Motion>(12);
  std::vector<Pose> start = std::vector<Pose>(12);
  JointWorkspace work;
  Island island{.bodies = members,
                .contacts = {},
                .rows = rows,
                .joints = IslandJoints({}, members, bodies, start, motion, work)};
  LocalSweeps local;

  Column() {
    bodies.velocity.resize(12);
    bodies.inverse_mass.assign(12, {1, 0});
    bodies.inverse_mass[0] = {};
    island.h = real(.01);
    for (std::uint32_t i = 0; i < 11; ++i) {
      ImpactRow& row = rows[i];
      row.a = i < 10 ? i : 0;
      row.b = i + 1;
      row.normal = {0, 1};
      row.mass_a = bodies.inverse_mass[row.a];
      row.mass_b = bodies.inverse_mass[row.b];
      row.count = 1;
      row.points[0].normal_mass = effective_mass(row, 0, 0);
    }
  }
  /// Whether sweeps may be local.
  bool find() { return local.find(island, ScalarContacts(bodies, motion), bodies.velocity.size(), real(.0001), false); }
  std::vector<std::uint32_t> found() { return {local.rows().begin(), local.rows().end()}; }
};

TEST(LocalSweeps, AreOfWhatGetsDeeperAndOfTwoBodiesRound) {
  Column column;
  column.bodies.velocity[10].v.y = -1;
  ASSERT_TRUE(column.find());
  EXPECT_THAT(column.found(), testing::ElementsAre(7, 8, 9));
}

TEST(LocalSweeps, PassNothingOnThroughWhatCannotBePushed) {
  Column column;
  column.bodies.velocity[11].v.y = -1;
  ASSERT_TRUE(column.find());
  EXPECT_THAT(column.found(), testing::ElementsAre(10));
  column.bodies.velocity[11].v.y = 0;
  column.bodies.velocity[1].v.y = -.5;
  column.bodies.velocity[2].v.y = -.5;
  ASSERT_TRUE(column.find());
  EXPECT_THAT(column.found(), testing::ElementsAre(0, 1, 2));
}

TEST(LocalSweeps, AreNotWorthItWhereNothingOrMostGetsDeeper) {
  Column column;
  EXPECT_FALSE(column.find());
  for (std::uint32_t i = 1; i < 12; ++i) column.bodies.velocity[i].v.y = i % 4 == 0 ? -1 : 0;
  EXPECT_FALSE(column.find());
}

TEST(LocalSweeps, LeaveOutContactsThatTakeNoPart) {
  Column column;
  column.bodies.velocity[10].v.y = -1;
  column.rows[8].active = false;
  ASSERT_TRUE(column.find());
  EXPECT_THAT(column.found(), testing::ElementsAre(9));
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::local_sweeps_test
