#include <gtest/gtest.h>

#include "forged_runs.h"

namespace plumb::start_test {
namespace {

TEST(StartInvariant, HoldsARunToTheStateOfItsScene) {
  const Scene scene = box_on_ground();
  const Stepping exact{.dt = 0.01, .h = 0.01, .epsilon = 1e-16};
  const auto begins = [](Vec position, Vec velocity) {
    return forged(0.01, {{box_at(position, velocity)}, {box_at({0, 0.5})}});
  };
  const InvariantCheck held = checked("start", scene, begins({0, 0.5}, {}), exact).value();
  EXPECT_EQ(held.status, CheckStatus::held);
  EXPECT_FALSE(is_evidence(held));
  EXPECT_EQ(status("start", scene, begins({0, 0.501}, {}), exact), CheckStatus::broken);
  EXPECT_EQ(status("start", scene, begins({0, 0.5}, {0, -0.1}), exact), CheckStatus::broken);
}

// 64 u of 0.5 + 0.71 m over 10 ms.
TEST(StartInvariant, KnowsThatAVelocityMayBeADifferenceOfPositions) {
  const Scene scene = box_on_ground();
  Stepping stepping{.dt = 0.01, .h = 0.01, .epsilon = 1e-16};
  const auto begins = [](double speed) { return forged(0.01, {{box_at({0, 0.5}, {0, speed})}, {box_at({0, 0.5})}}); };
  EXPECT_EQ(status("start", scene, begins(1e-13), stepping), CheckStatus::broken);
  stepping.differenced_velocities = true;
  EXPECT_EQ(status("start", scene, begins(1e-13), stepping), CheckStatus::held);
  EXPECT_EQ(status("start", scene, begins(1e-12), stepping), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb::start_test
