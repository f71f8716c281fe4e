// Copies of a world, to roll back to.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "../support.h"

namespace copy_test {
namespace {

using namespace impulse;

/// All of a world that a game can read, as it is.
std::vector<Real> state_of(World& world) {
  std::vector<Real> all;
  for (const BodyId id : world.bodies()) {
    const Body body = world.body(id);
    const Vec2 p = body.position();
    const Vec2 v = body.velocity();
    all.insert(all.end(),
               {p.x, p.y, body.angle(), v.x, v.y, body.angular_velocity(), body.awake() ? Real{1} : Real{0}});
  }
  for (const ContactInfo& contact : world.contacts()) {
    all.insert(all.end(), {contact.point.x, contact.point.y, contact.separation, contact.normal_impulse,
                           contact.tangent_impulse, static_cast<Real>(contact.a.index)});
  }
  if (world.settings().contact_events) {
    all.push_back(static_cast<Real>(world.contact_events().begun.size()));
    all.push_back(static_cast<Real>(world.contact_events().ended.size()));
  }
  return all;
}

struct Scene {
  std::string name;
  std::function<void(World&)> build;
};

std::vector<Scene> scenes() {
  return {{"stack and heap",
           [](World& world) {
             add_floor(world);
             for (int i = 0; i < 8; ++i) world.create_body(at(0, .5 + i), Shape::box({real(.5), real(.5)}));
             for (int i = 0; i < 60; ++i) {
               const double x = 6 + .9 * (i % 6) + .05 * (i / 6);
               world.create_body(at(x, .5 + i / 6), Shape::circle(real(.4)));
             }
           }},
          {"wide pyramid",
           [](World& world) {
             add_floor(world);
             for (int row = 0; row < 14; ++row) {
               for (int i = 0; i < 14 - row; ++i) {
                 world.create_body(at(i + .5 * row, .5 + row), Shape::box({real(.48), real(.5)}));
               }
             }
           }},
          {"joints, motor and spring",
           [](World& world) {
             const BodyId floor = add_floor(world);
             BodyId last = floor;
             for (int i = 0; i < 6; ++i) {
               const BodyId link = world.create_body(at(i + .5, 8), Shape::box({real(.5), real(.1)}));
               world.create_joint(RevoluteJoint{.a = last, .b = link, .anchor = {real(i), 8}});
               last = link;
             }
             const BodyId wheel = world.create_body(at(-5, 1), Shape::circle(1));
             const BodyId cart = world.create_body(at(-5, real(2.5)), Shape::box({1, real(.3)}));
             world.create_joint(RevoluteJoint{.a = cart, .b = wheel, .anchor = {-5, 1}, .motor = Motor{real(2), 20}});
             world.add_force(Spring{floor, cart, {-5, 8}, {}, 20, 3, 1});
           }},
          {"bullets and a wall", [](World& world) {
             add_floor(world);
             for (int i = 0; i < 5; ++i) world.create_body(at(10, .5 + i), Shape::box({real(.1), real(.5)}));
             for (int i = 0; i < 3; ++i) {
               BodyDef def = at(-20 - 40 * i, 2.5, 100);
               def.bullet = true;
               world.create_body(def, Shape::circle(real(.2)), frictionless(.5));
             }
           }}};
}

TEST(Copy, GoesOnWithTheSameBits) {
  for (const Scene& scene : scenes()) {
    for (const char* solver : {"accurate", "soft-step", "article"}) {
      for (const bool sleeping : {false, true}) {
        Settings settings;
        settings.solver = solver;
        settings.sleeping = sleeping;
        World world(settings);
        scene.build(world);
        for (int copies = 0; copies < 6; ++copies) {
          run(world, 37);
          World copy = world;
          for (int i = 0; i < 60; ++i) {
            world.step();
            copy.step();
            ASSERT_EQ(state_of(world), state_of(copy)) << scene.name << ", " << solver << ", step " << i;
          }
        }
      }
    }
  }
}

TEST(Copy, IsWhatAWorldRollsBackTo) {
  for (const Scene& scene : scenes()) {
    World world;
    scene.build(world);
    run(world, 50);
    const World saved = world;
    run(world, 60);
    const std::vector<Real> first = state_of(world);
    for (int times = 0; times < 3; ++times) {
      world = saved;
      run(world, 60);
      ASSERT_EQ(state_of(world), first) << scene.name;
    }
  }
}

TEST(Copy, ChangesNothingInTheWorld) {
  for (const Scene& scene : scenes()) {
    for (const bool sleeping : {false, true}) {
      Settings settings;
      settings.sleeping = sleeping;
      World copied(settings);
      World left_alone(settings);
      scene.build(copied);
      scene.build(left_alone);
      for (int i = 0; i < 240; ++i) {
        if (i % 7 == 0) const World copy = copied;
        copied.step();
        left_alone.step();
        ASSERT_EQ(state_of(copied), state_of(left_alone)) << scene.name << ", step " << i;
      }
    }
  }
}

TEST(Copy, IsIndependentAndKnowsTheSameHandles) {
  World world;
  add_floor(world);
  const BodyId a = world.create_body(at(0, 1), Shape::circle(1));
  const BodyId b = world.create_body(at(5, 1), Shape::circle(1));
  const JointId joint =
      world.create_joint(DistanceJoint{.a = a, .b = b, .anchor_a = {0, 1}, .anchor_b = {5, 1}, .length = 5});
  World copy = world;
  world.destroy_joint(joint);
  world.destroy_body(a);
  EXPECT_TRUE(copy.contains(a));
  EXPECT_TRUE(copy.contains(joint));
  copy.body(b).set_pose({9, 9}, 0);
  EXPECT_EQ(world.body(b).position().x, 5);
  run(copy, 10);
  run(world, 10);
  EXPECT_EQ(copy.body_count(), 3U);
  EXPECT_EQ(world.body_count(), 2U);
}

TEST(Copy, IsRefusedInACallbackOfTheWorld) {
  World world;
  world.create_body(at(0, 0), Shape::circle(1));
  const auto copy = [&world](BodyId, const Part&) {
    const World made = world;
    return true;
  };
  EXPECT_THROW(world.query_point({0, 0}, copy), std::logic_error);
}

}  // namespace
}  // namespace copy_test
