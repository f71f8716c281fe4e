// The filter and the pre-solve callback.
#include <gmock/gmock.h>

#include <random>
#include <vector>

#include "../solver/worlds.h"

namespace impulse::inline IMPULSE_PRECISION::callbacks_test {
namespace {

BodyDef fixed_at(double x, double y) {
  BodyDef def = at(x, y);
  def.type = BodyType::fixed;
  return def;
}

/// Discs and boxes that rain into a box, from the same seed.
World rain(const Settings& settings, int count = 120) {
  World world(settings);
  add_floor(world);
  for (const double side : {-5., 5.}) world.create_body(fixed_at(side, 20), Shape::box({real(.5), 20}));
  std::mt19937 random(7);
  for (int i = 0; i < count; ++i) {
    const BodyDef def = at(seeded(random, -4, 4), 1 + i * .3, 0, 0, seeded(random, -2, 2));
    const Material material{1, real(.5), real(.4), i % 3 == 0 ? real(.4) : real(0)};
    world.create_body(def, i % 2 == 0 ? Shape::circle(real(.3)) : Shape::box({real(.3), real(.25)}), material);
  }
  return world;
}

std::vector<Real> bits_of(World& world) {
  std::vector<Real> all;
  for (const BodyId id : world.bodies()) {
    const Body body = world.body(id);
    all.insert(all.end(), {body.position().x, body.position().y, body.angle(), body.velocity().x, body.velocity().y});
  }
  return all;
}

TEST(Filter, LetsBodiesPassThroughEachOther) {
  for (const bool sleeping : {false, true}) {
    Settings settings;
    settings.sleeping = sleeping;
    World world(settings);
    const BodyId floor = add_floor(world);
    const BodyId shelf = world.create_body(fixed_at(0, 3), Shape::box({2, real(.1)}));
    const BodyId ghost = world.create_body(at(-1, 5), Shape::circle(real(.5)));
    const BodyId other = world.create_body(at(1, 5), Shape::circle(real(.5)));
    world.set_filter([=](PartId a, PartId b) {
      EXPECT_LT(a.body.index, b.body.index);
      return !(a.body == shelf && b.body == ghost);
    });
    run(world, 200);
    EXPECT_NEAR(world.body(ghost).position().y, .5, .01) << "on the floor " << floor.index;
    EXPECT_NEAR(world.body(other).position().y, 3.6, .01);
    world.set_filter({});
    world.body(ghost).set_pose({-1, real(3.55)}, 0);
    run(world, 100);
    EXPECT_GT(world.body(ghost).position().y, 3.5) << "without a filter it lies on the shelf";
  }
}

TEST(Filter, LetsBulletsThrough) {
  World world;
  const BodyId wall = world.create_body(fixed_at(5, 0), Shape::box({real(.05), 5}));
  BodyDef def = at(0, 0, 400);
  def.bullet = true;
  const BodyId bullet = world.create_body(def, Shape::circle(real(.05)));
  World stopped = world;
  world.set_filter([=](PartId a, PartId) { return a.body != wall; });
  run(world, 10);
  run(stopped, 10);
  EXPECT_GT(world.body(bullet).position().x, 60);
  EXPECT_LT(stopped.body(bullet).position().x, 5);
}

TEST(Filter, AndPreSolveThatChangeNothingChangeNoBit) {
  for (const char* solver : {"accurate", "soft-step", "article"}) {
    for (const int workers : {1, 3}) {
      Settings settings;
      settings.solver = solver;
      settings.workers = workers;
      World plain = rain(settings, 40);
      World asked = plain;
      asked.set_filter([](PartId, PartId) { return true; });
      std::size_t calls = 0;
      asked.set_pre_solve([&calls](PreSolveContact&) { ++calls; });
      run(plain, 240);
      run(asked, 240);
      EXPECT_EQ(bits_of(plain), bits_of(asked)) << solver;
      EXPECT_GT(calls, 1000U);
    }
  }
}

TEST(PreSolve, GivesTheSameBitsWithAnyNumberOfWorkers) {
  std::vector<std::vector<Real>> ends;
  std::vector<std::vector<Real>> orders;
  for (const int workers : {1, 2, 4}) {
    Settings settings;
    settings.workers = workers;
    World world = rain(settings);
    world.set_filter([](PartId a, PartId b) { return (a.body.index + b.body.index) % 7 != 0 || a.body.index < 3; });
    std::vector<Real>& order = orders.emplace_back();
    world.set_pre_solve([&order](PreSolveContact& contact) {
      order.insert(order.end(),
                   {static_cast<Real>(contact.a.index), static_cast<Real>(contact.b.index), contact.separation});
      contact.enabled = contact.a.index < 3 || contact.normal.y > real(-.5);
      contact.restitution = contact.b.index % 2 == 0 ? real(.3) : real(0);
      contact.static_friction = real(.9);
    });
    run(world, 300);
    ends.push_back(bits_of(world));
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
  EXPECT_EQ(orders[0], orders[1]);
  EXPECT_EQ(orders[0], orders[2]);
}

TEST(PreSolve, MakesAPlatformOneWay) {
  for (const char* solver : {"accurate", "soft-step"}) {
    for (const double speed : {6., 40.}) {  // the faster passes within a step, where continuous collision would stop it
      Settings settings;
      settings.solver = solver;
      World world(settings);
      add_floor(world);
      const BodyId platform = world.create_body(fixed_at(0, 1.6), Shape::box({2, real(.05)}));
      const BodyId player = world.create_body(at(0, real(.5), 0, speed), Shape::circle(real(.4)));
      World solid = world;
      world.set_pre_solve([=](PreSolveContact& contact) {
        if (contact.a != platform && contact.b != platform) return;
        const Vec2 up = contact.a == platform ? contact.normal : -contact.normal;
        contact.enabled = up.y > real(.7) && contact.separation > real(-.05);
      });
      Real highest = 0;
      for (int i = 0; i < 700; ++i) {
        world.step();
        solid.step();
        highest = std::max(highest, world.body(player).position().y);
      }
      // Nothing takes speed from it on its way up.
      EXPECT_NEAR(highest, .5 + speed * speed / 20, .02 + speed / 60) << solver;
      EXPECT_NEAR(world.body(player).position().y, 2.05, .01) << solver << " lands on the platform";
      EXPECT_LT(solid.body(player).position().y, 1.5) << solver;
    }
  }
}

TEST(PreSolve, ChangesMaterialsForOneStep) {
  World world;
  add_floor(world);
  const BodyId box = world.create_body(at(0, .5, 5), Shape::box({real(.5), real(.5)}));
  bool ice = true;
  world.set_pre_solve([&ice](PreSolveContact& contact) {
    EXPECT_NEAR(contact.static_friction, .6, 1e-6) << "the bodies' own again";
    if (ice) contact.static_friction = contact.dynamic_friction = 0;
  });
  run(world, 60);
  EXPECT_NEAR(world.body(box).velocity().x, 5, 1e-3);
  ice = false;
  run(world, 30);
  EXPECT_NEAR(world.body(box).velocity().x, 5 - .6 * 10 * .5, .01);
  ice = true;
  const Real slower = world.body(box).velocity().x;
  world.set_pre_solve({});
  run(world, 10);
  EXPECT_LT(world.body(box).velocity().x, slower - .9);
}

TEST(PreSolve, SeesPlaceAndDepthOfAContact) {
  World world;
  const BodyId floor = add_floor(world);
  const BodyId ball = world.create_body(at(3, real(.49)), Shape::circle(real(.5)));
  int calls = 0;
  world.set_pre_solve([&](PreSolveContact& contact) {
    ++calls;
    EXPECT_EQ(contact.a, floor);
    EXPECT_EQ(contact.b, ball);
    EXPECT_EQ(contact.normal, (Vec2{0, 1}));
    EXPECT_NEAR(contact.separation, -.01, 1e-6);
    EXPECT_NEAR(contact.point.x, 3, 1e-6);
    EXPECT_NEAR(contact.point.y, -.005, 1e-6);
    EXPECT_EQ(world.body(ball).position().x, 3) << "the world can be read";
  });
  world.step();
  EXPECT_EQ(calls, 1);
}

TEST(PreSolve, OfDisabledContactsReportsNoTouch) {
  Settings settings;
  settings.contact_events = true;
  World world(settings);
  add_floor(world);
  world.create_body(at(0, .5), Shape::circle(real(.5)));
  world.set_pre_solve([](PreSolveContact& contact) { contact.enabled = false; });
  run(world, 3);
  EXPECT_TRUE(world.contact_events().touching.empty());
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_LT(world.body(world.bodies()[1]).position().y, .49);
}

TEST(PreSolve, RefusesCoefficientsOutOfRangeAndMovesNothing) {
  World world;
  add_floor(world);
  const BodyId ball = world.create_body(at(0, .5), Shape::circle(real(.5)));
  const auto refuses = [&](auto change) {
    world.set_pre_solve(change);
    EXPECT_THROW(world.step(), std::invalid_argument);
    EXPECT_EQ(world.body(ball).position(), (Vec2{0, real(.5)}));
  };
  refuses([](PreSolveContact& contact) { contact.restitution = 2; });
  refuses([](PreSolveContact& contact) { contact.dynamic_friction = -1; });
  refuses([](PreSolveContact& contact) { contact.static_friction = std::numeric_limits<Real>::quiet_NaN(); });
  refuses([](PreSolveContact& contact) { contact.static_friction = contact.dynamic_friction / 2; });
  world.set_pre_solve({});
  EXPECT_NO_THROW(world.step());
}

TEST(PreSolve, MayReadTheWorldButNotChangeIt) {
  World world;
  add_floor(world);
  const BodyId ball = world.create_body(at(0, .5), Shape::circle(real(.5)));
  const auto refused = [&](auto change) {
    bool called = false;
    world.set_pre_solve([&](PreSolveContact&) {
      called = true;
      EXPECT_THROW(change(), std::logic_error);
    });
    world.step();
    EXPECT_TRUE(called);
  };
  refused([&] { world.create_body(at(5, 5), Shape::circle(1)); });
  refused([&] { world.destroy_body(ball); });
  refused([&] { world.body(ball).set_velocity({1, 0}, 0); });
  refused([&] { world.body(ball).set_pose({1, 0}, 0); });
  refused([&] { world.set_gravity({}); });
  refused([&] { world.step(); });
  refused([&] { world.set_filter({}); });
  refused([&] { const World copy = world; });
  EXPECT_EQ(world.body_count(), 2U);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::callbacks_test
