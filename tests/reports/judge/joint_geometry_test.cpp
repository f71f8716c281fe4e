#include "reports/judge/joint_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/judge/mechanics.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb::joint_geometry_test {
namespace {

// A box 2 m to the right of a fixed body.
Scene joined(const Joint& joint) {
  return {.bodies = {{.name = "base", .type = BodyType::fixed},
                     {.name = "box", .position = {2, 0}, .shapes = {{Box{}, {.density = 1}}}}},
          .joints = {joint}};
}

double error_at(const Joint& joint, BodyState moved) {
  const Scene scene = joined(joint);
  std::vector<BodyState> states = initial_states(scene);
  states[1] = moved;
  return JointGeometry(scene).error(0, states);
}

TEST(JointGeometry, MeasuresByHowMuchAJointIsViolated) {
  const BodyState start{.position = {2, 0}};
  const BodyState right{.position = {2.5, 0}};
  const BodyState up{.position = {2, 0.5}};
  const Joint point = Revolute{.a = 0, .b = 1};
  const Joint line = Prismatic{.a = 0, .b = 1, .axis = {1, 0}};
  const Joint rod = Distance{.a = 0, .b = 1, .anchor_b = {2, 0}, .length = 2};
  const Joint spring = Distance{.a = 0, .b = 1, .anchor_b = {2, 0}, .length = 2, .stiffness = 1};
  for (const Joint& joint : {point, line, rod, spring}) EXPECT_EQ(error_at(joint, start), 0);
  EXPECT_DOUBLE_EQ(error_at(point, right), 0.5);
  EXPECT_DOUBLE_EQ(error_at(line, right), 0);
  EXPECT_DOUBLE_EQ(error_at(line, up), 0.5);
  EXPECT_DOUBLE_EQ(error_at(rod, right), 0.5);
  EXPECT_DOUBLE_EQ(error_at(spring, right), 0);
  // Turned about the anchor, 2 m to the left of the centre, nothing is violated.
  EXPECT_NEAR(error_at(point, {.position = rotated({2, 0}, 0.3), .angle = 0.3}), 0, 1e-15);
}

// A box of 1 kg and 1/6 kg m^2, 2 m from the anchor: a pull along the arm meets 1 kg, one across it 1/(1 + 6 2^2) kg.
TEST(JointGeometry, StoresWhatASoftConstraintDoes) {
  const auto stored = [](const Joint& joint, BodyState moved) {
    const Scene scene = joined(joint);
    std::vector<BodyState> states = initial_states(scene);
    states[1] = moved;
    return JointGeometry(scene).stored(0, states, 10);
  };
  const Joint hinge = Revolute{.a = 0, .b = 1};
  const Joint weld = Weld{.a = 0, .b = 1};
  const Joint rod = Distance{.a = 0, .b = 1, .anchor_b = {2, 0}, .length = 2};
  const Joint rail = Prismatic{.a = 0, .b = 1, .axis = {1, 0}};
  EXPECT_EQ(stored(hinge, {.position = {2, 0}}), 0);
  EXPECT_DOUBLE_EQ(stored(hinge, {.position = {2.5, 0}}), 100 * 0.25 / 2);
  EXPECT_DOUBLE_EQ(stored(hinge, {.position = {2, 0.5}}), 100 * 0.25 / 2 / 25);
  EXPECT_NEAR(stored(hinge, {.position = rotated({2, 0}, 0.3), .angle = 0.3}), 0, 1e-12);
  EXPECT_NEAR(stored(weld, {.position = rotated({2, 0}, 0.3), .angle = 0.3}), 100 * 0.09 / 6 / 2, 1e-12);
  EXPECT_DOUBLE_EQ(stored(rod, {.position = {2.5, 0}}), 100 * 0.25 / 2);
  EXPECT_EQ(stored(rail, {.position = {2.5, 0.5}}), 0) << "not known";
}

TEST(JointGeometry, HasLimitsThatAreMeasuredFromTheStart) {
  const Joint limited = Revolute{.a = 0, .b = 1, .limits = Limits{-0.2, 0.1}};
  const auto turned = [](double angle) { return BodyState{.position = rotated({2, 0}, angle), .angle = angle}; };
  EXPECT_NEAR(error_at(limited, turned(0.1)), 0, 1e-15);
  EXPECT_NEAR(error_at(limited, turned(-0.2)), 0, 1e-15);
  EXPECT_NEAR(error_at(limited, turned(0.15)), 0.05 * 2, 1e-15);
  EXPECT_NEAR(error_at(limited, turned(-0.3)), 0.1 * 2, 1e-15);

  const Scene scene = joined(limited);
  std::vector<BodyState> states = initial_states(scene);
  states[1].angular_velocity = 3;
  const JointGeometry joints(scene);
  EXPECT_EQ(joints.rows(states).size(), 3u) << "two for the anchor, one for the limit";
  EXPECT_DOUBLE_EQ(joints.passes_limits(0, states, 0.01), 0);
  EXPECT_DOUBLE_EQ(joints.passes_limits(0, states, 0.05), 0.05 * 2);
  states[1].angle = -0.05;
  EXPECT_DOUBLE_EQ(joints.room(0, states)->low, 0.15);
  EXPECT_DOUBLE_EQ(joints.room(0, states)->high, 0.15);
  EXPECT_EQ(joints.rows(states).back().limits_of, 0u);
}

TEST(JointGeometry, TellsByHowMuchAMotorSpeedsAHingeUp) {
  const Scene scene = joined(Revolute{.a = 0, .b = 1, .motor = Motor{3, 6}});
  std::vector<BodyState> states = initial_states(scene);
  states[1].angular_velocity = 1;
  const JointGeometry joints(scene);
  const double inertia = mass_of(scene.bodies[1]).inertia;
  EXPECT_DOUBLE_EQ(joints.driven_by(0, states, 1e-3), 6e-3 / inertia) << "its strength says how much";
  EXPECT_DOUBLE_EQ(joints.driven_by(0, states, 10), 2) << "its speed does";
  EXPECT_EQ(JointGeometry(joined(Revolute{.a = 0, .b = 1})).driven_by(0, states, 10), 0);
}

TEST(JointGeometry, HasLimitsOfAWay) {
  const Joint limited = Prismatic{.a = 0, .b = 1, .axis = {2, 0}, .limits = Limits{-0.2, 0.1}};
  EXPECT_DOUBLE_EQ(error_at(limited, {.position = {2.05, 0}}), 0);
  EXPECT_NEAR(error_at(limited, {.position = {2.15, 0}}), 0.05, 1e-15);
  EXPECT_NEAR(error_at(limited, {.position = {1.7, 0}}), 0.1, 1e-15);

  const Scene scene = joined(limited);
  std::vector<BodyState> states = initial_states(scene);
  states[1].velocity = {3, 4};
  const JointGeometry joints(scene);
  EXPECT_EQ(joints.rows(states).size(), 3u) << "one across, one for the limit, one for the angle";
  EXPECT_EQ(joints.rows(states)[1].limits_of, 0u);
  EXPECT_DOUBLE_EQ(joints.room(0, states)->low, 0.2);
  EXPECT_DOUBLE_EQ(joints.room(0, states)->high, 0.1);
  EXPECT_DOUBLE_EQ(joints.room(0, states)->rate, 3);
  EXPECT_DOUBLE_EQ(joints.passes_limits(0, states, 0.01), 0);
  EXPECT_NEAR(joints.passes_limits(0, states, 0.05), 0.05, 1e-15);
}

// A row's impulse does no work on motions that the joint allows: J v = 0.
TEST(JointGeometry, HasDirectionsThatAllowedMotionsDoNotFollow) {
  const Scene scene = joined(Revolute{.a = 0, .b = 1});
  std::vector<BodyState> states = initial_states(scene);
  states[1].velocity = {0, 2};
  states[1].angular_velocity = 1;
  const JointGeometry joints(scene);
  ASSERT_EQ(joints.rows(states).size(), 2u);
  for (const JointRow& row : joints.rows(states)) {
    EXPECT_NEAR(dot(row.direction, states[1].velocity) + row.turn_b * states[1].angular_velocity, 0, 1e-15);
  }
  // On the tangent, its anchor leaves the circle of 2 m by 2 (1 dt)^2/2.
  EXPECT_DOUBLE_EQ(joints.linearisation(0, states, 0.01), 1e-4);
}

}  // namespace
}  // namespace plumb::joint_geometry_test
