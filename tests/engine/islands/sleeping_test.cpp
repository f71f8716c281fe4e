#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "../random_shapes.h"
#include "sleepers.h"

namespace sleeping_test {
namespace {

using namespace impulse;
using testing::Each;
using testing::IsEmpty;
using testing::SizeIs;

class Sleeping : public testing::TestWithParam<const char*> {
 protected:
  static Settings settings() {
    Settings chosen = sleeping_allowed(GetParam());
    // Without accumulated impulses, a column only comes to rest as far as the iterations of one step allow.
    if (chosen.solver == "article") chosen.iterations = 200;
    return chosen;
  }
  World world_{settings()};
};

TEST_P(Sleeping, AColumnComesToRestFallsAsleepAndStaysInPlace) {
  add_floor(world_);
  const std::vector<BodyId> boxes = add_column(world_, 0, 3);
  EXPECT_THAT(awake(world_, boxes), Each(true));
  EXPECT_LT(steps_to_sleep(world_), 1200);
  EXPECT_THAT(awake(world_, boxes), Each(false));
  for (const BodyId box : boxes) {
    EXPECT_EQ(world_.body(box).velocity(), Vec2{});
    EXPECT_EQ(world_.body(box).angular_velocity(), 0);
  }
  const std::vector<BodyState> asleep = states(world_);
  run(world_, 120);
  EXPECT_EQ(states(world_), asleep);
}

TEST_P(Sleeping, AWokenColumnContinuesAsIfItHadNotSlept) {
  add_floor(world_);
  const std::vector<BodyId> boxes = add_column(world_, 0, 3);
  ASSERT_LT(steps_to_sleep(world_), 1200);
  run(world_, 60);
  const std::vector<BodyState> asleep = states(world_);
  world_.body(boxes[1]).wake();
  EXPECT_THAT(awake(world_, boxes), Each(true));
  for (int i = 0; i < 20; ++i) {
    world_.step();
    const std::vector<BodyState> now = states(world_);
    for (std::size_t k = 0; k < now.size(); ++k) {
      // It was slower than this when it fell asleep. Without warm starting, a step would give it g dt = 0.17 m/s.
      EXPECT_LE(length(now[k].velocity), world_.settings().sleep_linear_speed) << k << " in step " << i;
      EXPECT_LE(std::abs(now[k].spin), world_.settings().sleep_angular_speed);
      EXPECT_NEAR(length(now[k].position - asleep[k].position), 0, .001);
    }
  }
}

TEST_P(Sleeping, AHitWakesTheWholeIslandAndNoOther) {
  add_floor(world_);
  const std::vector<BodyId> hit = add_column(world_, 0, 3);
  const std::vector<BodyId> spared = add_column(world_, 5, 3);
  ASSERT_LT(steps_to_sleep(world_), 1200);
  const BodyId ball = world_.create_body(at(-2, 2.5, 6, 1), Shape::circle(real(.3)));
  int step = 0;
  for (; step < 60 && !world_.body(hit[0]).awake(); ++step) {
    EXPECT_THAT(awake(world_, hit), Each(false));
    world_.step();
  }
  // 1.2 m at 6 m/s: in the twelfth step, or up to three steps earlier with a solver that looks ahead.
  EXPECT_NEAR(step, 11, 3);
  EXPECT_THAT(awake(world_, hit), Each(true));
  EXPECT_THAT(awake(world_, spared), Each(false));
  run(world_, 3);
  EXPECT_GT(world_.body(hit[2]).velocity().x, .2);  // has its share of the ball's momentum
  EXPECT_LT(world_.body(ball).velocity().x, 5);
}

TEST_P(Sleeping, BodiesFallWhenTheirSupportIsRemoved) {
  const BodyId floor = add_floor(world_);
  const std::vector<BodyId> boxes = add_column(world_, 0, 2);
  for (const bool destroy : {false, true}) {
    ASSERT_LT(steps_to_sleep(world_), 1200);
    if (destroy) {
      world_.destroy_body(floor);
    } else {
      world_.remove_body(floor);
    }
    EXPECT_THAT(awake(world_, boxes), Each(true));
    world_.step();
    EXPECT_LT(world_.body(boxes[0]).velocity().y, -.1);
    EXPECT_THAT(world_.contact_events().ended, SizeIs(1));
    if (!destroy) world_.insert_body(floor);
  }
}

TEST_P(Sleeping, FallingAsleepAndWakingCauseNoEvents) {
  add_floor(world_);
  const std::vector<BodyId> boxes = add_column(world_, 0, 2);
  run(world_, 20);
  const auto step_without_events = [&] {
    world_.step();
    const ContactEvents events = world_.contact_events();
    EXPECT_THAT(events.begun, IsEmpty());
    EXPECT_THAT(events.ended, IsEmpty());
    EXPECT_THAT(events.touching, SizeIs(2));
    // Each contact carries the load above it, asleep or not: m g dt up to jitter.
    for (const TouchingParts& pair : events.touching) EXPECT_GT(pair.normal_impulse, 0);
  };
  for (int i = 0; i < 1200 && world_.awake_count() > 0; ++i) step_without_events();
  ASSERT_EQ(world_.awake_count(), 0U);
  for (int i = 0; i < 5; ++i) step_without_events();
  EXPECT_THAT(world_.contacts(), SizeIs(4));
  world_.body(boxes[1]).wake();
  for (int i = 0; i < 5; ++i) step_without_events();
}

TEST_P(Sleeping, ABallAtItsApexIsNotAtRest) {
  // With lower gravity it is slow for longer: below 0.01 m/s for four seconds.
  for (const double gravity : {10., .1, .005}) {
    world_.set_gravity({0, real(-gravity)});
    const double speed = gravity * 5;
    const BodyId ball = world_.create_body(at(0, 0, 0, speed), Shape::circle(real(.3)));
    run(world_, 590);
    EXPECT_TRUE(world_.body(ball).awake()) << gravity;
    EXPECT_NEAR(world_.body(ball).velocity().y, speed - gravity * 590 / 60, 1e-4 * (1 + speed));
    world_.destroy_body(ball);
  }
}

TEST_P(Sleeping, ACreepingBodyIsNotAtRest) {
  add_floor(world_, frictionless());
  const BodyId slow = world_.create_body(at(0, .5, .001, 0), unit_box(), frictionless());
  run(world_, 600);
  EXPECT_TRUE(world_.body(slow).awake());
  EXPECT_NEAR(world_.body(slow).position().x, .01, 1e-4);
}

TEST_P(Sleeping, GivesTheSameBitsForAnyNumberOfWorkers) {
  const auto end = [](int workers) {
    Settings shared = settings();
    shared.workers = workers;
    World world(shared);
    add_floor(world);
    for (int i = 0; i < 4; ++i) add_column(world, 3 * i, 2);
    run(world, 200);
    world.create_body(at(-3, 1.5, 5, 0), Shape::circle(real(.4)));
    run(world, 100);
    return states(world);
  };
  EXPECT_EQ(end(1), end(3));
}

INSTANTIATE_TEST_SUITE_P(WithEverySolver, Sleeping,
                         testing::Values("accurate", "article", "block", "exact", "sequential-impulse", "soft-step",
                                         "split-impulse", "xpbd"),
                         [](const testing::TestParamInfo<const char*>& solver) {
                           std::string name = solver.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Sleep, IsOffByDefault) {
  World world;
  add_floor(world);
  add_column(world, 0, 2);
  run(world, 300);
  EXPECT_EQ(world.awake_count(), 2U);
}

TEST(Sleep, ChangesNoBitsUntilSomethingSleeps) {
  const auto end = [](bool sleeping) {
    Settings settings = sleeping_allowed();
    settings.sleeping = sleeping;
    World world(settings);
    add_floor(world);
    add_column(world, 0, 5);
    world.create_body(at(-4, 3, 6, 0), Shape::circle(real(.4)));
    run(world, 25);
    EXPECT_EQ(world.awake_count(), 6U);
    return states(world);
  };
  EXPECT_EQ(end(true), end(false));
}

// Resting bodies connected by joints form an island, whether other bodies sleep or not.
TEST(Sleep, ComesToOneIslandAfterAnother) {
  World world(sleeping_allowed());
  const BodyId floor = add_floor(world);
  add_column(world, 0, 1);
  ASSERT_LT(steps_to_sleep(world), 600);
  const std::vector<BodyId> later = add_column(world, 5, 2);
  world.create_joint(WeldJoint{floor, later[0], {5, 0}});
  world.create_joint(WeldJoint{later[0], later[1], {5, 1}});
  EXPECT_LT(steps_to_sleep(world), 600);
}

TEST(Sleep, ScalesItsImpulsesWithTheStep) {
  World world(sleeping_allowed());
  add_floor(world);
  add_column(world, 0, 1);
  ASSERT_LT(steps_to_sleep(world), 600);
  const auto sum_of_impulses = [&] {
    Real sum = 0;
    for (const ContactInfo& contact : world.contacts()) sum += contact.normal_impulse;
    return sum;
  };
  const Real before = sum_of_impulses();
  ASSERT_GT(before, 0);
  world.set_dt(world.dt() / 4);
  world.step();
  EXPECT_EQ(world.awake_count(), 0u);
  EXPECT_EQ(sum_of_impulses(), before / 4);
}

TEST(Sleep, WaitsForTheSleepTimeOfTheSettings) {
  for (const double time : {.25, 1.}) {
    Settings settings = sleeping_allowed();
    settings.sleep_time = real(time);
    settings.gravity = {};
    World world(settings);
    world.create_body(at(0, 0), unit_box());
    // One step to detect that it is at rest, then the sleep time.
    EXPECT_NEAR(steps_to_sleep(world), 1 + 60 * time, 1);
  }
}

TEST(Sleep, RejectsInvalidThresholdsByName) {
  for (const double bad : {0., -1., HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    for (const auto& [name, field] :
         std::vector<std::pair<std::string, Real Settings::*>>{{"sleep_linear_speed", &Settings::sleep_linear_speed},
                                                               {"sleep_angular_speed", &Settings::sleep_angular_speed},
                                                               {"sleep_time", &Settings::sleep_time}}) {
      Settings settings;
      settings.*field = real(bad);
      try {
        validate(settings);
        ADD_FAILURE() << name << " = " << bad;
      } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(name + " must be"));
      }
    }
  }
}

// The mass on a soft spring turns back so slowly that it stays below 0.01 m/s for four seconds, 0.6 m away from its
// rest position.
TEST(Sleep, DoesNotMistakeATurningPointForRest) {
  Settings settings = sleeping_allowed();
  settings.gravity = {};
  World world(settings);
  const BodyId ball = world.create_body(at(.6, 0), Shape::circle(Real{0.5}));
  const Real mass = world.body(ball).mass().mass;
  world.add_force(Spring{{}, ball, {}, {}, real(.008) * mass, 0, 0});
  run(world, 1200);
  EXPECT_TRUE(world.body(ball).awake());
}

TEST(Sleep, OfOneBodyWaitsForItsWholeIsland) {
  World world(sleeping_allowed());
  const BodyId floor = add_floor(world);
  const std::vector<BodyId> boxes = add_column(world, 0, 2);
  const BodyId fan = world.create_body(at(0, 3), Shape::box({real(.4), real(.1)}));
  world.create_joint(RevoluteJoint{boxes[1], fan, {0, 3}, {}, Motor{3, 1}});
  const BodyId alone = world.create_body(at(5, .5), unit_box());
  run(world, 300);
  EXPECT_THAT(awake(world, boxes), Each(true));
  EXPECT_FALSE(world.body(alone).awake());
  EXPECT_TRUE(world.body(floor).awake());
}

TEST(Sleep, CanBeForcedForAWholeIsland) {
  World world(sleeping_allowed());
  const BodyId floor = add_floor(world);
  const std::vector<BodyId> boxes = add_column(world, 0, 2);
  const BodyId high = world.create_body(at(5, 9), unit_box());
  run(world, 10);
  world.body(boxes[0]).sleep();
  world.body(high).sleep();
  EXPECT_THAT(awake(world, boxes), Each(false));
  EXPECT_EQ(world.body(high).velocity(), Vec2{});
  const std::vector<BodyState> asleep = states(world);
  run(world, 10);
  EXPECT_EQ(states(world), asleep);
  EXPECT_THROW(world.body(floor).sleep(), std::invalid_argument);
}

TEST(Sleep, DoesNotHideBodiesFromQueriesRaysAndDrawing) {
  World world(sleeping_allowed());
  add_floor(world);
  const BodyId box = world.create_body(at(0, .5), unit_box());
  ASSERT_LT(steps_to_sleep(world), 600);
  int found = 0;
  const auto count = [&](BodyId id, const Part&) {
    found += id == box ? 1 : 0;
    return true;
  };
  world.query_point({0, real(.5)}, count);
  world.query_aabb({{-1, real(.4)}, {1, real(.6)}}, count);
  EXPECT_EQ(found, 2);
  EXPECT_EQ(world.ray_cast({0, 5}, {0, real(.7)})->body, box);

  struct Roles : DebugDraw {
    int asleep = 0;
    void polygon(std::span<const Vec2>, DrawRole role) override { asleep += role == DrawRole::asleep ? 1 : 0; }
    void circle(Vec2, Real, Vec2, DrawRole) override {}
    void segment(Vec2, Vec2, DrawRole) override {}
    void point(Vec2, DrawRole) override {}
  } roles;
  world.debug_draw(roles, {{-2, -2}, {2, 2}});
  EXPECT_EQ(roles.asleep, 1);
}

// A body that passes within a solver's speculative margin, but not towards the sleepers, does not wake them.
TEST(Sleep, IsNotInterruptedByAPassingBody) {
  World world(sleeping_allowed());
  add_floor(world);
  const std::vector<BodyId> boxes = add_column(world, 0, 1);
  ASSERT_LT(steps_to_sleep(world), 600);
  BodyDef bird = at(-3, 1.4, 9, 0);
  bird.gravity_scale = 0;
  const BodyId flying = world.create_body(bird, Shape::circle(real(.3)));
  run(world, 60);
  EXPECT_GT(world.body(flying).position().x, 3);
  EXPECT_FALSE(world.body(boxes[0]).awake());
}

TEST(Sleep, HandlesBodiesThatAreRemovedAndInserted) {
  World world(sleeping_allowed());
  add_floor(world);
  const std::vector<BodyId> boxes = add_column(world, 0, 3);
  ASSERT_LT(steps_to_sleep(world), 600);
  world.remove_body(boxes[1]);
  EXPECT_FALSE(world.body(boxes[1]).awake());
  EXPECT_TRUE(world.body(boxes[2]).awake());
  world.insert_body(boxes[1]);
  EXPECT_EQ(world.awake_count(), 3U);
  ASSERT_LT(steps_to_sleep(world), 600);
  world.destroy_body(boxes[2]);
  ASSERT_LT(steps_to_sleep(world), 600);
  EXPECT_EQ(world.body_count(), 3U);
}

// A sleeping pyramid of 55 boxes gives solvers nothing to do, and a ball moving beside it does not wake it.
TEST(Sleep, GivesSolversOnlyAwakeBodies) {
  World world(sleeping_allowed("soft-step"));
  add_floor(world);
  for (int row = 0; row < 10; ++row) {
    for (int i = 0; i < 10 - row; ++i) world.create_body(at(i + .5 * row, .5 + row), unit_box());
  }
  EXPECT_EQ(world.awake_count(), 55U);
  ASSERT_LT(steps_to_sleep(world, 3000), 3000);
  const std::size_t in_pyramid = world.contacts().size();
  EXPECT_GE(in_pyramid, 2U * 55U);
  world.create_body(at(30, .5, 1, 0), Shape::circle(Real{0.5}));
  run(world, 30);
  EXPECT_EQ(world.awake_count(), 1U);
  EXPECT_EQ(world.contacts().size(), in_pyramid + 1);
}

// For random changes to the world: sleepers never move, and nothing that a step may move touches them.
TEST(Sleep, SurvivesAnyChangeToTheWorld) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    RandomShapes random(seed);
    World world(sleeping_allowed(seed % 2 == 0 ? "soft-step" : "accurate"));
    const BodyId floor = add_floor(world);
    std::vector<BodyId> ids;
    std::vector<BodyId> removed;
    std::vector<JointId> joints;
    std::size_t slept = 0;
    for (int step = 0; step < 900; ++step) {
      const auto pick = [&] {
        return ids[static_cast<std::size_t>(random.number(0, static_cast<double>(ids.size()) - .001))];
      };
      const auto action = static_cast<int>(random.number(0, 300));  // mostly nothing, so that bodies can fall asleep
      if (ids.size() < 12 || (action == 0 && ids.size() < 25)) {
        BodyDef def = at(0, 6);
        def.position.x = random.number(-9, 9);
        if (ids.size() % 6 == 5) def = kind(BodyType::kinematic, at(def.position.x, .2));
        ids.push_back(world.create_body(def, ids.size() % 2 == 0 ? Shape::circle(real(.4)) : unit_box()));
      } else if (action == 1) {
        const BodyId gone = pick();
        world.destroy_body(gone);
        std::erase(ids, gone);
      } else if (action == 2) {
        removed.push_back(pick());
        world.remove_body(removed.back());
      } else if (action == 3) {
        for (const BodyId id : ids) world.insert_body(id);
        removed.clear();
      } else if (action == 4) {
        world.body(pick()).set_velocity({random.number(-1, 1), 0}, 0);
      } else if (action == 5) {
        const Real x = random.number(-9, 9);
        world.body(pick()).set_pose({x, 3}, x);
      } else if (action == 6) {
        const BodyId id = pick();
        if (world.body(id).type() == BodyType::dynamic) world.body(id).sleep();
      } else if (action == 7) {
        const BodyId id = pick();
        if (world.body(id).type() == BodyType::dynamic)
          joints.push_back(world.create_joint(RevoluteJoint{floor, id, world.body(id).center()}));
      } else if (action == 8 && !joints.empty()) {
        if (world.contains(joints.back())) world.destroy_joint(joints.back());
        joints.pop_back();
      }
      world.step();
      slept += world.awake_count() + 2 < ids.size() ? 1 : 0;
      for (const BodyId id : ids) {
        const Body body = world.body(id);
        ASSERT_TRUE(std::isfinite(body.position().x) && std::isfinite(body.position().y)) << seed;
        if (!body.awake() && std::count(removed.begin(), removed.end(), id) == 0) {
          ASSERT_EQ(body.velocity(), Vec2{}) << seed;
        }
      }
      const auto moves = [&](BodyId id) {
        const Body body = world.body(id);
        return body.awake() && (body.type() == BodyType::dynamic || body.velocity() != Vec2{});
      };
      const auto sleeps = [&](BodyId id) { return !world.body(id).awake(); };
      for (const TouchingParts& pair : world.contact_events().touching) {
        ASSERT_FALSE(moves(pair.a) && sleeps(pair.b)) << seed << " in step " << step;
        ASSERT_FALSE(moves(pair.b) && sleeps(pair.a)) << seed << " in step " << step;
      }
    }
    EXPECT_GT(slept, 100U) << seed;
  }
}

}  // namespace
}  // namespace sleeping_test
