// Bodies at rest in a pile keep their contacts for many steps (resting_piles.h), unless contact events are on: worlds
// with events are the reference.
#include "solver/resting_piles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::resting_piles_test {
namespace {

constexpr int rows = 12;
constexpr double friction = .6;

/// An empty world in which piles rest or, because a callback sees each contact in each step, don't.
World empty_world(bool rests, int workers) {
  Settings chosen = accurate();
  chosen.workers = workers;
  World world(chosen);
  if (!rests) world.set_pre_solve([](PreSolveContact&) {});
  return world;
}

BodyDef fixed_at(double x, double y) {
  BodyDef def = at(x, y);
  def.type = BodyType::fixed;
  return def;
}

/// Boxes of 1 m in `rows` rows; after three seconds all is still.
World pyramid(bool rests, int workers = 1) {
  World world = empty_world(rests, workers);
  ground(world, material(0, friction));
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      world.create_body(at(1.01 * i + .505 * row, .5 + row), Shape::box(vec(.5, .5)), material(0, friction));
    }
  }
  run_for(world, 3);
  return world;
}

/// 700 discs in a box that have come to rest, so many that what moves on them does not wake them.
World heap(bool rests, int workers = 1) {
  World world = empty_world(rests, workers);
  std::mt19937 random(3);
  ground(world, material(0, friction));
  for (const double side : {-1., 1.}) {
    world.create_body(fixed_at(side * 9, 20), Shape::box(vec(.5, 20)), material(0, friction));
  }
  for (int i = 0; i < 700; ++i) {
    const BodyDef def = at((i % 27 - 13) * .61 + seeded(random, -.05, .05), .3 + .6 * (i / 27));
    world.create_body(def, Shape::circle(real(seeded(random, .2, .28))), material(0, friction));
  }
  run_for(world, 8);
  return world;
}

/// The largest difference of a coordinate (m).
double apart(World& a, World& b) {
  double worst = 0;
  for (const BodyId id : a.bodies()) {
    worst = std::max(worst, static_cast<double>(length(a.body(id).position() - b.body(id).position())));
  }
  return worst;
}

double deepest(const World& world) {
  double most = 0;
  for (const ContactInfo& contact : world.contacts()) most = std::max(most, -static_cast<double>(contact.separation));
  return most;
}

BodyId drop(World& world, double x, double y, double speed, double density = 1) {
  Material m = material(0, friction);
  m.density = real(density);
  return world.create_body(at(x, y, 0, -speed), Shape::circle(real(.4)), m);
}

/// Runs both kinds of world; the bits must differ, which shows that a pile was cached.
struct Twins {
  World resting, asked;

  explicit Twins(const std::function<World(bool, int)>& make) : resting(make(true, 1)), asked(make(false, 1)) {
    EXPECT_GT(apart(resting, asked), 0) << "nothing came to rest";
  }
  void both(const std::function<void(World&)>& act) {
    act(resting);
    act(asked);
  }
};

// Normals and arms are constant while a pile rests, and wrong by up to tremor / size = .004 rad: .4 % of the load. What
// rolls on a heap (a few discs do, by centimetres) is not at rest, nor are discs on the ground that bear nothing, and
// what lies on top of those follows: all but one in twenty stay, by much less than bodies at rest may move.
TEST(RestingPiles, StayWhereTheyAre) {
  for (const auto& make : {pyramid, heap}) {
    Twins twins(make);
    World start = make(false, 1);
    twins.both([](World& world) { run_for(world, 10); });
    std::size_t stayed = 0;
    for (const BodyId id : start.bodies()) {
      const Vec2 asked = twins.asked.body(id).position();
      const Real moved = length(asked - start.body(id).position());
      const Real apart = length(twins.resting.body(id).position() - asked);
      if (std::max(moved, apart) <= RestingPile::tremor / 8) ++stayed;
    }
    EXPECT_GT(20 * stayed, 19 * start.bodies().size());
  }
}

TEST(RestingPiles, ReportTheirLoads) {
  World world = pyramid(true);
  run_for(world, 1);
  double load = 0;
  double weight = 0;
  for (const ContactInfo& contact : world.contacts()) {
    const bool on_ground = contact.a.index == 0 || contact.b.index == 0;
    if (on_ground) load += static_cast<double>(contact.normal_impulse);
  }
  for (const BodyId id : world.bodies()) weight += static_cast<double>(world.body(id).mass().mass) * g;
  EXPECT_NEAR(load * 60, weight, 1e-3 * weight);
}

// The pile is hit in both worlds with the same contacts, except those that began in the repeated search.
TEST(RestingPiles, RespondToBodiesThatFallOnThem) {
  for (const double speed : {.5, 20.}) {
    Twins twins(heap);
    const double top = 14 + speed / 10;
    std::vector<double> after;
    twins.both([&](World& world) {
      const BodyId ball = drop(world, .3, top, speed, 5);
      double most = 0;
      for (int i = 0; i < 90; ++i) {
        world.step();
        most = std::max(most, deepest(world));
      }
      after.push_back(static_cast<double>(world.body(ball).position().y));
      after.push_back(most);
    });
    EXPECT_NEAR(after[0], after[2], .5) << speed;
    EXPECT_LT(after[1], 2 * after[3] + .001) << "overlaps at " << speed;
  }
}

TEST(RestingPiles, CollapseWhenABodyIsRemoved) {
  World world = pyramid(true);
  const std::vector<BodyId> below{world.bodies()[1], world.bodies()[2]};
  const BodyId above = world.bodies()[1 + rows];
  const double before = static_cast<double>(world.body(above).position().y);
  for (const BodyId id : below) world.destroy_body(id);
  run_for(world, 1);
  EXPECT_LT(static_cast<double>(world.body(above).position().y), before - .1);
}

TEST(RestingPiles, ArePushedAsideByKinematicBodies) {
  World world = pyramid(true);
  BodyDef def = at(-3, .5);
  def.type = BodyType::kinematic;
  const BodyId ram = world.create_body(def, Shape::box(vec(1, .4)), material(0, friction));
  run_for(world, 1);
  world.body(ram).set_velocity({4, 0}, 0);
  double most = 0;
  for (int i = 0; i < 60; ++i) {
    world.step();
    most = std::max(most, deepest(world));
  }
  EXPECT_GT(static_cast<double>(world.body(world.bodies()[1]).position().x), 1);
  EXPECT_LT(most, .05);
}

TEST(RestingPiles, FallUpWhenGravityIsReversed) {
  Twins twins(pyramid);
  twins.both([](World& world) {
    world.set_gravity({0, 10});
    run_for(world, 1);
  });
  for (const BodyId id : twins.resting.bodies()) {
    const double speed = static_cast<double>(twins.resting.body(id).velocity().y);
    EXPECT_NEAR(speed, static_cast<double>(twins.asked.body(id).velocity().y), .01);
    if (id.index > 0) {
      EXPECT_GT(speed, 9.9);
    }
  }
}

TEST(RestingPiles, AreHeldByJointsAddedLater) {
  Twins twins(pyramid);
  twins.both([](World& world) {
    const BodyId top = world.bodies().back();
    const Vec2 from = world.body(top).position();
    world.create_joint(DistanceJoint{top, world.bodies().front(), from, from + vec(0, 5), 5});
    world.destroy_body(world.bodies()[3]);
    run_for(world, .5);
  });
  EXPECT_LT(apart(twins.resting, twins.asked), .02);
}

TEST(RestingPiles, RestWhileContactEventsAreKept) {
  World quiet = pyramid(true);
  World watched = quiet;
  Settings chosen = watched.settings();
  quiet.set_settings(chosen);  // as the next line does
  chosen.contact_events = true;
  watched.set_settings(chosen);
  run_for(quiet, 2);
  run_for(watched, 2);
  EXPECT_EQ(apart(quiet, watched), 0);
  World unrested = pyramid(false);
  run_for(unrested, 2);
  EXPECT_GT(apart(watched, unrested), 0) << "nothing came to rest";
  double reported = 0;
  double listed = 0;
  for (const TouchingParts& parts : watched.contact_events().touching) {
    reported += static_cast<double>(parts.normal_impulse);
  }
  for (const ContactInfo& contact : quiet.contacts()) listed += static_cast<double>(contact.normal_impulse);
  EXPECT_NEAR(reported, listed, 1e-5 * listed);
}

// Without the copy of the pile at rest, the copied world would solve all contacts anew, as the twin does.
TEST(RestingPiles, GoOnInACopyOfTheWorld) {
  Twins twins(pyramid);
  World left_alone = pyramid(true);
  World copy = twins.resting;
  for (int i = 0; i < 120; ++i) {
    if (i == 60) {
      for (World* world : {&left_alone, &copy, &twins.resting}) drop(*world, 6, 14, 2);
    }
    for (World* world : {&left_alone, &copy, &twins.resting}) world->step();
    if (i == 90) copy = twins.resting;
    ASSERT_EQ(apart(copy, twins.resting), 0) << i;
    ASSERT_EQ(apart(copy, left_alone), 0) << i;
  }
}

TEST(RestingPiles, EndInTheSameBitsWithAnyNumberOfThreads) {
  std::vector<std::vector<Vec2>> ends;
  for (const int workers : {1, 2, 3}) {
    World world = heap(true, workers);
    drop(world, 2, 15, 3);
    run_for(world, 3);
    std::vector<Vec2> end;
    for (const BodyId id : world.bodies()) end.push_back(world.body(id).position());
    ends.push_back(end);
  }
  for (const std::vector<Vec2>& end : ends) {
    EXPECT_EQ(std::memcmp(end.data(), ends[0].data(), end.size() * sizeof(Vec2)), 0);
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::resting_piles_test
