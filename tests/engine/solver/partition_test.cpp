#include "solver/partition.h"

#include <gtest/gtest.h>

#include "contact_graph.h"

namespace impulse::inline IMPULSE_PRECISION::partition_test {

namespace {

TEST(Partition, KeepsItsIslandsWhileTheSameContactsLast) {
  Graph graph(6);
  graph.touch(0, 1, 1);
  graph.touch(1, 2, 1);
  graph.touch(3, 4, 2);
  const std::uint64_t version = graph.split(false).version();
  EXPECT_EQ(graph.split(false).version(), version);
  EXPECT_EQ(graph.split(false).contacts(1).size(), 2U);  // of bodies 1 and 2

  graph.touch(4, 5, 1);
  const Partition& parts = graph.split(false);
  EXPECT_NE(parts.version(), version);
  EXPECT_EQ(parts.bodies(2).size(), 3U);
}

TEST(Partition, FindsContactsThatRotateNothing) {
  Graph graph(3);
  graph.touch(0, 1, 1);
  graph.touch(1, 2, 1);
  const auto smooth = [&](std::uint32_t contact) {
    const Partition& parts = graph.split(true);
    for (const Tie& tie : parts.contacts(0)) {
      if (tie.contact == contact) return tie.smooth;
    }
    ADD_FAILURE() << contact;
    return false;
  };
  EXPECT_FALSE(smooth(0)) << "1 is no disc";
  graph.contacts()[0].disc_b = true;
  EXPECT_TRUE(smooth(0)) << "0 is no disc, and at rest";
  graph.contacts()[1].disc_a = true;
  EXPECT_FALSE(smooth(1)) << "2 is no disc";
  graph.contacts()[1].disc_b = true;
  EXPECT_TRUE(smooth(1));
  graph.contacts()[1].static_friction = Real{1} / 2;
  EXPECT_FALSE(smooth(1));
  graph.bodies().velocity[0].w = 1;
  EXPECT_FALSE(smooth(0)) << "0 is no disc, and turns";
}

TEST(Partition, ListsPointsAgainAfterForgetPoints) {
  Graph graph(2);
  graph.touch(0, 1, 1);
  graph.count_changes(1);
  EXPECT_EQ(graph.split(false).contacts(1)[0].points, 1);
  graph.contacts()[0].count = 2;
  EXPECT_EQ(graph.split(false).contacts(1)[0].points, 1);
  graph.forget_points();
  EXPECT_EQ(graph.split(false).contacts(1)[0].points, 2);
}

// The floor starts moving: now it connects the bodies on it.
TEST(Partition, FindsItsIslandsAgainWhenABodyStartsMoving) {
  Graph graph(3);
  graph.touch(0, 1, 1);
  graph.touch(0, 2, 1);
  EXPECT_EQ(graph.split(false).size(), 3U);
  graph.bodies().velocity[0].v = {1, 0};
  EXPECT_EQ(graph.split(false).size(), 1U);
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::partition_test
