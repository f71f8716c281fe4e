#include "core/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "../support.h"
#include "impulse/impulse.h"

namespace impulse::inline IMPULSE_PRECISION::workers_test {
namespace {

TEST(Workers, DoEveryPieceOnce) {
  for (const int count : {1, 2, 5}) {
    Workers workers(count);
    for (int round = 0; round < 50; ++round) {
      std::vector<int> done(37, 0);
      workers.share_out(done.size(), [&](std::size_t piece, std::size_t) { ++done[piece]; });
      EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; }));
    }
  }
}

TEST(Workers, NeverConfusePiecesOfTwoRounds) {
  for (const int count : {2, 5}) {
    Workers workers(count);
    for (int round = 1; round <= 3000; ++round) {
      std::vector<int> seen(static_cast<std::size_t>(2 + round % 7), 0);
      workers.share_out(seen.size(), [&, round](std::size_t piece, std::size_t) { seen[piece] += round; });
      ASSERT_TRUE(std::all_of(seen.begin(), seen.end(), [=](int now) { return now == round; })) << round;
    }
  }
}

TEST(Workers, RethrowAnExceptionAndContinueWorking) {
  Workers workers(2);
  const auto fails = [](std::size_t piece, std::size_t) {
    if (piece == 3) throw std::runtime_error("piece 3");
  };
  EXPECT_THROW(workers.share_out(8, fails), std::runtime_error);
  int done = 0;
  workers.share_out(1, [&](std::size_t, std::size_t) { ++done; });
  EXPECT_EQ(done, 1);
}

/// Final positions of the bodies of forty piles on one floor, bouncing, sliding, some with hinges.
std::vector<Vec2> final_positions(int workers) {
  Settings settings;
  settings.workers = workers;
  World world(settings);
  BodyDef floor;
  floor.type = BodyType::fixed;
  const BodyId ground = world.create_body(floor, Shape::half_space({0, 1}, 0));
  std::vector<BodyId> ids;
  for (int pile = 0; pile < 40; ++pile) {
    for (int i = 0; i < 3; ++i) {
      BodyDef def = at(4 * pile + 0.1 * i, 0.6 + 1.1 * i, 0.5 * i);
      def.angle = real(0.1 * pile);
      Material material;
      material.restitution = real(0.1 * (pile % 8));
      ids.push_back(pile % 2 == 0 ? world.create_body(def, Shape::box({0.5, 0.5}), material)
                                  : world.create_body(def, Shape::circle(0.5), material));
    }
    if (pile % 5 == 0) world.create_joint(RevoluteJoint{ground, ids.back(), {real(4 * pile), 5}});
  }
  for (int i = 0; i < 60; ++i) world.step();
  std::vector<Vec2> positions;
  positions.reserve(ids.size());
  for (const BodyId id : ids) positions.push_back(world.body(id).position());
  return positions;
}

TEST(Workers, GiveTheSameBitsForAnyNumber) {
  const std::vector<Vec2> alone = final_positions(1);
  EXPECT_EQ(final_positions(2), alone);
  EXPECT_EQ(final_positions(3), alone);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::workers_test
