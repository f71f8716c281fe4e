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
  const std::uint64_t version = graph.split().version();
  EXPECT_EQ(graph.split().version(), version);
  EXPECT_EQ(graph.split().contacts(1).size(), 2U);  // of bodies 1 and 2

  graph.touch(4, 5, 1);
  const Partition& parts = graph.split();
  EXPECT_NE(parts.version(), version);
  EXPECT_EQ(parts.bodies(2).size(), 3U);
}

TEST(Partition, FindsContactsThatRotateNothing) {
  Graph graph(3);
  graph.touch(0, 1, 1);
  graph.touch(1, 2, 1);
  const auto smooth = [&](std::uint32_t contact) {
    const Partition& parts = graph.split();
    for (std::size_t island = 0; island < parts.size(); ++island) {
      for (const Tie& tie : parts.contacts(island)) {
        if (tie.contact == contact) return tie.smooth;
      }
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
  EXPECT_EQ(graph.split().contacts(1)[0].points, 1);
  graph.contacts()[0].count = 2;
  EXPECT_EQ(graph.split().contacts(1)[0].points, 1);
  graph.forget_points();
  EXPECT_EQ(graph.split().contacts(1)[0].points, 2);
}

// The floor starts moving: now it connects the bodies on it.
TEST(Partition, FindsItsIslandsAgainWhenABodyStartsMoving) {
  Graph graph(3);
  graph.touch(0, 1, 1);
  graph.touch(0, 2, 1);
  EXPECT_EQ(graph.split().size(), 3U);
  graph.bodies().velocity[0].v = {1, 0};
  EXPECT_EQ(graph.split().size(), 1U);
}

TEST(Partition, ConnectsBodiesOnOneSpring) {
  Graph graph(4);
  graph.tie(1, 3);
  const Partition& parts = graph.split();
  EXPECT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts.bodies(1).size(), 2U);
  EXPECT_EQ(parts.pulls(1).size(), 1U);
  EXPECT_TRUE(parts.varies(1));
  EXPECT_FALSE(parts.varies(2)) << "no spring pulls body 2";
  EXPECT_TRUE(parts.pulls(2).empty());
}

TEST(Partition, DampingOfOneBodyConcernsNoOther) {
  Graph graph(3);
  graph.bodies().response[2].linear_damping = 1;
  const Partition& parts = graph.split();
  EXPECT_EQ(parts.size(), 3U);
  EXPECT_FALSE(parts.varies(1));
  EXPECT_TRUE(parts.varies(2));
}

// Whether a body comes into the reach of another is not known before the step.
TEST(Partition, ConnectsBodiesThatOneMovingBodyAttracts) {
  Graph graph(4);
  graph.bodies().pose[3].p = {100, 0};
  graph.forces().add(Attraction{.from = graph.bodies().id(1), .strength = 1, .reach = 1}, graph.bodies());
  EXPECT_EQ(graph.split().bodies(1).size(), 3U);

  Graph held(4);
  held.forces().add(Attraction{.from = held.bodies().id(0), .strength = 1}, held.bodies());
  EXPECT_EQ(held.split().size(), 4U) << "what pulls them rests";
  EXPECT_TRUE(held.split().varies(3));
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::partition_test
