#include <gmock/gmock.h>

#include <stdexcept>
#include <vector>

#include "sleepers.h"

namespace waking_test {
namespace {

using namespace impulse;
using testing::Each;
using testing::IsEmpty;

/// A box asleep on a floor beside another.
class Waking : public testing::Test {
 protected:
  Waking() {
    floor_ = add_floor(world_);
    box_ = world_.create_body(at(0, .5), unit_box());
    other_ = world_.create_body(at(3, .5), unit_box());
    fall_asleep();
  }
  void fall_asleep() {
    ASSERT_LT(steps_to_sleep(world_), 1200);
    world_.step();
  }
  Body box() { return world_.body(box_); }
  Body other() { return world_.body(other_); }

  World world_{sleeping_allowed()};
  BodyId floor_, box_, other_;
};

TEST_F(Waking, HappensWithForcesTorquesAndImpulses) {
  for (const auto& push :
       std::vector<void (*)(Body)>{[](Body body) {
                                     body.apply_force({1, 0});
                                   },
                                   [](Body body) {
                                     body.apply_force({1, 0}, {0, 1});
                                   },
                                   [](Body body) { body.apply_torque(1); },
                                   [](Body body) {
                                     body.apply_impulse({real(.01), 0}, {0, 1});
                                   },
                                   [](Body body) {
                                     body.set_velocity({1, 0}, 0);
                                   },
                                   [](Body body) {
                                     body.set_pose({-1, real(.5)}, 0);
                                   },
                                   [](Body body) { body.set_gravity_scale(2); }, [](Body body) { body.set_layers(1); },
                                   [](Body body) { body.wake(); }}) {
    push(box());
    EXPECT_TRUE(box().awake());
    EXPECT_FALSE(other().awake());
    fall_asleep();
  }
}

TEST_F(Waking, AppliesTheImpulseThatCausesIt) {
  box().apply_impulse({2, 0}, box().center());
  EXPECT_EQ(box().velocity(), (Vec2{2, 0}));  // 1 kg
}

TEST_F(Waking, DoesNotHappenWithAForceOfZero) {
  box().apply_force({0, 0});
  box().apply_torque(0);
  box().apply_impulse({0, 0}, {0, 0});
  world_.step();
  EXPECT_EQ(world_.awake_count(), 0U);
}

TEST_F(Waking, HappensWhenAJointIsCreatedOrDestroyed) {
  const JointId joint = world_.create_joint(DistanceJoint{box_, other_, {0, real(.5)}, {3, real(.5)}, 3});
  EXPECT_EQ(world_.awake_count(), 2U);
  fall_asleep();
  box().apply_force({real(.1), 0});
  EXPECT_TRUE(other().awake());  // one island now
  fall_asleep();
  world_.destroy_joint(joint);
  EXPECT_EQ(world_.awake_count(), 2U);
  fall_asleep();
  box().wake();
  EXPECT_FALSE(other().awake());
}

TEST_F(Waking, HappensWhenAPersistentForceIsAddedOrRemoved) {
  const std::vector<Force> all{ConstantForce{box_, {real(.1), 0}, 0},
                               Spring{{}, box_, {0, 2}, {}, real(.1), real(1.5), 0},
                               Spring{floor_, box_, {0, 2}, {}, real(.1), real(1.5), 0}};
  for (const Force& force : all) {
    const ForceId id = world_.add_force(force);
    EXPECT_TRUE(box().awake());
    EXPECT_FALSE(other().awake());
    fall_asleep();
    world_.remove_force(id);
    EXPECT_TRUE(box().awake());
    fall_asleep();
  }
  const ForceId pull = world_.add_force(Attraction{box_, real(.01), 2});
  EXPECT_EQ(world_.awake_count(), 2U);
  fall_asleep();
  world_.remove_force(pull);
  EXPECT_EQ(world_.awake_count(), 2U);
}

TEST_F(Waking, ReachesBodiesConnectedByASpringOrAnAttraction) {
  const ForceId spring = world_.add_force(Spring{box_, other_, {}, {}, real(.1), 3, 0});
  fall_asleep();
  box().wake();
  EXPECT_TRUE(other().awake());
  world_.remove_force(spring);
  world_.add_force(Attraction{box_, real(.01), 2, false, 4});
  const BodyId far = world_.create_body(at(-9, .5), unit_box());
  fall_asleep();
  box().wake();
  EXPECT_TRUE(other().awake());
  EXPECT_FALSE(world_.body(far).awake());
}

TEST_F(Waking, HappensWithAnotherGravityButNotWithAnotherStep) {
  world_.set_dt(real(.01));
  world_.step();
  EXPECT_EQ(world_.awake_count(), 0U);
  world_.set_gravity({0, 10});
  EXPECT_EQ(world_.awake_count(), 2U);
  run(world_, 10);
  EXPECT_NEAR(box().velocity().y, 1, .05);
}

TEST_F(Waking, HappensWhenSleepingIsTurnedOff) {
  Settings settings = world_.settings();
  settings.sleeping = false;
  world_.set_settings(settings);
  EXPECT_EQ(world_.awake_count(), 2U);
  for (int i = 0; i < 5; ++i) {
    world_.step();
    EXPECT_THAT(world_.contact_events().begun, IsEmpty());
    EXPECT_LT(length(box().velocity()), .001);
  }
  EXPECT_THROW(box().sleep(), std::logic_error);
}

TEST_F(Waking, HappensWhenATouchingKinematicBodyStartsToMove) {
  const BodyId lift = world_.create_body(kind(BodyType::kinematic, at(0, -.49)), unit_box());
  EXPECT_TRUE(box().awake());  // a body was placed where it is
  EXPECT_FALSE(other().awake());
  fall_asleep();
  world_.body(lift).set_velocity({0, 1}, 0);
  run(world_, 60);
  EXPECT_NEAR(box().position().y, 1.5, .02);
  EXPECT_TRUE(box().awake());  // carried by the lift, as at any speed
  world_.body(lift).set_velocity({0, real(.001)}, 0);
  run(world_, 600);
  EXPECT_TRUE(box().awake());
  world_.body(lift).set_velocity({}, 0);
  fall_asleep();
  EXPECT_FALSE(other().awake());
}

TEST_F(Waking, HappensWithAJointToAMovingKinematicBody) {
  const BodyId hook = world_.create_body(kind(BodyType::kinematic, at(0, 5)), unit_box());
  world_.create_joint(DistanceJoint{hook, box_, {0, 5}, {0, real(.5)}, real(4.5)});
  fall_asleep();
  world_.body(hook).set_velocity({0, 1}, 0);
  run(world_, 30);
  EXPECT_TRUE(box().awake());
  EXPECT_NEAR(box().position().y, 1, .02);
  EXPECT_FALSE(other().awake());
}

TEST_F(Waking, HappensWhenASupportIsMovedAway) {
  const BodyId shelf = world_.create_body(kind(BodyType::fixed, at(9, 2)), Shape::box({1, real(.1)}));
  const BodyId vase = world_.create_body(at(9, 2.6), unit_box());
  fall_asleep();
  world_.body(shelf).set_pose({-9, 2}, 0);
  EXPECT_TRUE(world_.body(vase).awake());
  EXPECT_FALSE(box().awake());
  run(world_, 30);
  EXPECT_LT(world_.body(vase).position().y, 2);
}

TEST_F(Waking, HappensWhenAFixedBodyIsPlacedThere) {
  const BodyId wall = world_.create_body(kind(BodyType::fixed, at(20, 0)), Shape::box({1, 1}));
  EXPECT_EQ(world_.awake_count(), 0U);
  world_.body(wall).set_pose({real(-1.2), 1}, 0);
  EXPECT_TRUE(box().awake());
  EXPECT_FALSE(other().awake());
}

TEST_F(Waking, RestoresTheLoadsOfAHangingChain) {
  std::vector<BodyId> chain;
  BodyId above = world_.create_body(kind(BodyType::fixed, at(9, 9)), Shape::circle(real(.1)));
  for (int i = 0; i < 4; ++i) {
    const BodyId link = world_.create_body(at(9, 8.5 - i), Shape::capsule({0, real(-.4)}, {0, real(.4)}, real(.05)));
    world_.create_joint(RevoluteJoint{above, link, {9, real(9. - i)}});
    chain.push_back(link);
    above = link;
  }
  fall_asleep();
  const std::vector<BodyState> asleep = states(world_);
  world_.body(chain[3]).wake();
  EXPECT_THAT(awake(world_, chain), Each(true));
  run(world_, 5);
  const std::vector<BodyState> now = states(world_);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_NEAR(length(now[i].position - asleep[i].position), 0, 1e-4);
    EXPECT_LT(length(now[i].velocity), 1e-3);
  }
}

}  // namespace
}  // namespace waking_test
