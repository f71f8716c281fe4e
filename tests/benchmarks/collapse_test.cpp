#include "collapse.h"

#include <gtest/gtest.h>

#include <limits>

#include "courses/pyramid.h"
#include "reports/judge/mechanics.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

Start three_rows() {
  Start start{.size = 1};
  add_pyramid(start, 3, {0, 0});
  return start;
}

TEST(Condition, OfAPyramidAsBuiltIsSound) {
  const Start start = three_rows();
  EXPECT_EQ(start.rests.size(), 6U);
  const Condition found = condition(start, initial_states(start.scene));
  EXPECT_EQ(found.broken, "");
  EXPECT_EQ(found.overlap.most, 0);
}

TEST(Condition, AllowsAPyramidToSinkAsAWhole) {
  const Start start = three_rows();
  std::vector<BodyState> states = initial_states(start.scene);
  for (BodyState& state : states) state.position.y *= 0.95;
  const Condition found = condition(start, states);
  EXPECT_EQ(found.broken, "");
  EXPECT_NEAR(found.overlap.mean, 0.05, 1e-12);
  EXPECT_NEAR(found.overlap.most, 0.05, 1e-12);
}

TEST(Condition, NoticesABoxThatSlippedOffTheRowBelow) {
  const Start start = three_rows();
  std::vector<BodyState> states = initial_states(start.scene);
  states.back().position.x += 0.49;
  EXPECT_EQ(condition(start, states).broken, "");
  states.back().position.x += 0.02;
  EXPECT_EQ(condition(start, states).broken, "body 5 has fallen from 3");
}

TEST(Condition, NoticesWhatIsNoNumber) {
  const Start start = three_rows();
  std::vector<BodyState> states = initial_states(start.scene);
  states[4].angular_velocity = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(condition(start, states).broken, "body 4 is nowhere");
}

TEST(Condition, NoticesADynamicBodyThatLeft) {
  Start start{.size = 1, .center = {1, 0}, .reach = 2};
  start.scene.bodies = {fixed(box("wall", {9, 0}, {1, 1}, {})), box("box", {-1, 0}, {1, 1}, {})};
  std::vector<BodyState> states = initial_states(start.scene);
  EXPECT_EQ(condition(start, states).broken, "");
  states[1].position.x -= 1e-9;
  EXPECT_EQ(condition(start, states).broken, "body 1 has left");
}

TEST(Condition, NoticesOverlapsOfMoreThanAQuarterOnTheMean) {
  Start start{.size = 0.8};
  start.scene.bodies = {disc("", {0, 0}, 0.4, {}), disc("", {0.5, 0}, 0.4, {}), disc("", {1.22, 0}, 0.4, {})};
  std::vector<BodyState> states = initial_states(start.scene);
  const Condition found = condition(start, states);
  EXPECT_EQ(found.broken, "");
  EXPECT_NEAR(found.overlap.mean, 0.19, 1e-12);
  EXPECT_NEAR(found.overlap.most, 0.3, 1e-12);
  states[2].position.x = 1.18;
  EXPECT_EQ(condition(start, states).broken, "bodies overlap by 0.21 m on the mean");
}

TEST(Condition, NoticesAHingeThatGapesAndNoneThatTurns) {
  Start start{.size = 0.8};
  start.scene.bodies = {disc("", {0, 0}, 0.4, {}), disc("", {1, 0}, 0.4, {})};
  start.scene.joints = {Revolute{.a = 0, .b = 1, .anchor = {0.5, 0}}};
  std::vector<BodyState> states = initial_states(start.scene);
  states[1] = {.position = {0.5, 0.5}, .angle = 90 * degree};
  EXPECT_EQ(condition(start, states).broken, "");
  states[1].position.y = 1.29;
  EXPECT_EQ(condition(start, states).broken, "");
  states[1].position.y = 1.31;
  EXPECT_EQ(condition(start, states).broken, "the hinge of 0 and 1 gapes by 0.81 m");
}

}  // namespace
}  // namespace plumb::benchmarks
