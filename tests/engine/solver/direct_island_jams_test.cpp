// Small islands whose laws cannot all be met, or contradict each other by rounding: what they bear stays bounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::direct_island_jams_test {
namespace {

// A body held by two that nothing pushes, deeper than it can part from both: what pushes it out of one pushes it into
// the other. It stays, and bears no more than a thousand times what would stop it at the rate at which it is pushed out
// of either.
TEST(DirectIsland, BearsBoundedImpulsesInAJam) {
  World world(falling());
  add_floor(world);
  const BodyId jammed = world.create_body(at(0, .45), Shape::box({real(.5), real(.5)}));
  BodyDef lid = at(0, 1.4);
  lid.type = BodyType::fixed;
  world.create_body(lid, Shape::box({1, real(.5)}));
  const double most_push = .001 * 240;  // m/s
  for (int step = 0; step < 60; ++step) {
    world.step();
    ASSERT_NEAR(static_cast<double>(world.body(jammed).position().y), .45, .05) << step;  // or it is out of one
    double sum = 0;
    for (const ContactInfo& contact : world.contacts()) sum += static_cast<double>(contact.normal_impulse);
    // Both, before the drift and after it, in each of four sub-steps: shorter intervals have no solution either.
    const double most = 1e3 * static_cast<double>(world.body(jammed).mass().mass) * 2 * most_push;
    ASSERT_LE(sum, 2 * 4 * most) << step;
  }
}

// What passes under a hinged box, .4 m deep in it, has to be in it. Such jams bore 1e10 N s a step, and a millionth of
// that, as the normal turned, shot the box out of its hinge with 1e8 rad/s.
TEST(DirectIsland, ShootsNothingOutOfAJamUnderItsHinge) {
  for (const int i : {4, 8, 11}) {
    World world(falling());
    BodyDef ground = at(0, -3);
    ground.type = BodyType::fixed;
    const BodyId floor = world.create_body(ground, Shape::half_space({0, 1}, 0));
    const BodyId box = world.create_body(at(0, .6, 0, 0, 0, .1 * i), Shape::box({real(.5), real(.5)}));
    world.create_joint(RevoluteJoint{floor, box, world.body(box).center()});
    BodyDef passes = at(.2 * i - 1, 0, -.6);
    passes.type = BodyType::kinematic;
    world.create_body(passes, Shape::box({real(.5), real(.5)}));
    for (int step = 0; step < 150; ++step) {
      world.step();
      ASSERT_LE(length(world.body(box).velocity()), 2) << i << " in step " << step;
      ASSERT_LE(std::abs(world.body(box).angular_velocity()), 20) << i << " in step " << step;
    }
  }
}

BodyId add_plate(World& world, double y, double half_width, double speed, const Material& material) {
  BodyDef plate = at(0, y, 0, -speed);
  plate.type = BodyType::kinematic;
  return world.create_body(plate, Shape::box({real(half_width), real(.2)}), material);
}

double fastest(World& world, const std::vector<BodyId>& bodies) {
  double most = 0;
  for (const BodyId body : bodies) most = std::max(most, static_cast<double>(length(world.body(body).velocity())));
  return most;
}

// Boxes under a plate that comes down at .4 m/s can go nowhere: static friction holds them. Where a normal turned by a
// thousandth, they were squeezed out at up to 1900 m/s.
TEST(DirectIsland, SqueezesNoColumnOutUnderAPlate) {
  for (const double friction : {.2, .5, .8}) {
    World world(falling());
    const Material rough = material(0, friction);
    ground(world, rough);
    std::vector<BodyId> boxes(3);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const BodyDef def = at(i == 1 ? .07 : 0, .25 + .5 * static_cast<double>(i));
      boxes[i] = world.create_body(def, Shape::box({real(.3), real(.25)}), rough);
    }
    add_plate(world, 1.8, 2, .4, rough);
    for (int step = 0; step < 110; ++step) {
      world.step();
      ASSERT_LE(fastest(world, boxes), .4) << "friction " << friction << " in step " << step;
    }
  }
}

// Six discs between two walls under a plate: they wedge each other apart, with a leverage that grows without bound, and
// were shot out at up to 3300 m/s.
TEST(DirectIsland, ShootsNoDiscsOutUnderAPlate) {
  for (const double friction : {0., .2, .5}) {
    World world(falling());
    const Material rough = material(0, friction);
    ground(world, rough);
    for (const double x : {-.7, .7}) {
      BodyDef wall = at(x, 1);
      wall.type = BodyType::fixed;
      world.create_body(wall, Shape::box({real(.1), 2}), rough);
    }
    std::vector<BodyId> discs(6);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const BodyDef def = at(i % 2 == 0 ? -.3 : .3, .31 + .3 * static_cast<double>(i));
      discs[i] = world.create_body(def, Shape::circle(real(.28)), rough);
    }
    add_plate(world, 2.6, .55, .7, rough);
    for (int step = 0; step < 110; ++step) {
      world.step();
      ASSERT_LE(fastest(world, discs), 16 * .7) << "friction " << friction << " in step " << step;
    }
  }
}

// A disc slides in a body along a line that another disc of it stops: six equations and a contact say how three bodies
// move. Within an interval as short as between two impacts, the rounding of a gap, or what is not linear in it, is a
// speed that contradicts them. The contact bore 2e6 N s of that, 9e6 in single precision, and its friction stopped all.
TEST(DirectIsland, BearsNoContradictionBetweenBodiesThatJointsHold) {
  World world(falling());
  const auto add = [&world](const BodyDef& def, const Shape& shape, double density, double friction, double bounce) {
    return world.create_body(def, shape, {real(density), real(friction), real(friction), real(bounce)});
  };
  BodyDef floor;
  floor.type = BodyType::fixed;
  add(floor, Shape::half_space({0, 1}, 0), 1, .6, .43);
  const Shape capsule = Shape::capsule({real(-.08937), 0}, {real(.08937), 0}, real(.20853));
  const BodyId base = add(at(.7241, .3959, 0, 0, 0, -.7949), capsule, 2.09, .4967, 1);
  const BodyId head = add(at(1.1109, 1.588), Shape::circle(real(.3246)), .7053, .3827, .687);
  const BodyId slider = add(at(.0906, 1.9945), Shape::circle(real(.4203)), 3.544, .9201, 0);
  BodyDef damped = at(-.2981, .24);
  damped.linear_damping = real(1.3614);
  damped.angular_damping = real(1.588);
  const BodyId foot = add(damped, Shape::circle(real(.1194)), 7.205, .7203, 0);
  const BodyId stop = add(at(.6423, 1.1379), Shape::circle(real(.2448)), 1.742, .5459, 0);
  world.create_joint(WeldJoint{base, head, {real(.9175), real(.99195)}});
  world.create_joint(WeldJoint{head, stop, {real(.8766), real(1.36295)}});
  world.create_joint(PrismaticJoint{base, slider, {real(.40735), real(1.1952)}, {real(-.0636344), real(-.9979733)}});
  world.create_joint(PrismaticJoint{head, foot, {real(.4064), real(.914)}, {real(-.599328), real(-.8005036)}});
  for (int step = 0; step < 60; ++step) {
    world.step();
    for (const ContactInfo& contact : world.contacts()) {
      ASSERT_LT(static_cast<double>(contact.normal_impulse), 1000) << step;  // of 3 kg that fall at 5 m/s
    }
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::direct_island_jams_test
