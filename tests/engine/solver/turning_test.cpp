// Contacts are found once in a step of 1/60 s; still, bodies in violent motion must not overlap by more than the method
// states.
#include "solver/turning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "../random_shapes.h"
#include "../support.h"
#include "contact_graph.h"
#include "narrow_phase/collide.h"

namespace impulse::inline IMPULSE_PRECISION::turning_test {
namespace {

const Material wood{1, real(.4), real(.4), 0};

/// m, the penetration of two bodies of one shape each.
double depth(World& world, BodyId a, BodyId b) {
  const Body one = world.body(a);
  const Body other = world.body(b);
  const Manifold m = collide(one.parts()[0].shape, {one.position(), one.rotation()}, other.parts()[0].shape,
                             {other.position(), other.rotation()}, 0);
  double deepest = 0;
  for (int i = 0; i < m.count; ++i) {
    deepest = std::max(deepest, -static_cast<double>(m.points[static_cast<std::size_t>(i)].separation));
  }
  return deepest;
}

/// m, the deepest overlap of any two within some steps.
double deepest(World& world, int steps) {
  double deepest = 0;
  for (int step = 0; step < steps; ++step) {
    world.step();
    const std::span<const BodyId> all = world.bodies();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) deepest = std::max(deepest, depth(world, all[i], all[j]));
    }
  }
  return deepest;
}

TEST(Stir, IgnoresTheRotationOfADisc) {
  Graph graph(3);
  graph.touch(1, 2, 1);
  Contact& contact = graph.contacts()[0];
  BodySet& bodies = graph.bodies();
  bodies.velocity[1].w = 5;
  EXPECT_GT(stir_of(contact, bodies).speed, 0);
  EXPECT_EQ(stir_of(contact, bodies).turning, 5);
  contact.disc_a = true;
  EXPECT_EQ(stir_of(contact, bodies).speed, 0);
  EXPECT_EQ(stir_of(contact, bodies).turning, 0);
  bodies.velocity[2].v = {1, 0};
  EXPECT_EQ(stir_of(contact, bodies).speed, 1);
}

// A sum of components would follow a scene more closely when it is turned by an eighth.
TEST(Stir, IsTheSameInATurnedScene) {
  Graph graph(3);
  graph.touch(1, 2, 1);
  graph.bodies().velocity[2].v = {3, 4};
  EXPECT_EQ(stir_of(graph.contacts()[0], graph.bodies()).speed, 5);
}

// Each leans on the next with a corner that slides along a face while that turns, and in the end they lie on each
// other: 11 mm deep when normals stood still.
TEST(Turning, DominoesDoNotOverlap) {
  World world{Settings{}};
  add_floor(world, wood);
  for (int i = 0; i < 6; ++i) world.create_body(at(.6 * i, .5), Shape::box({real(.1), real(.5)}), wood);
  Body first = world.body(world.bodies()[1]);
  first.set_velocity({1, real(.2)}, -2);
  EXPECT_LT(deepest(world, 240), static_cast<double>(tolerated_sink));
}

// 10 m/s are 42 mm in a sub-step, which one sweep of soft contacts let through.
TEST(Turning, AnImpactOnAWallCausesNoOverlapOfItsBoxes) {
  for (const char* solver : {"accurate", "accurate-scalar"}) {
    Settings settings;
    settings.solver = solver;
    settings.gravity = {};
    World world(settings);
    world.create_body(at(-3, 0, 10), Shape::box({1, 1}), {8, real(.4), real(.4), 0});
    for (int i = 0; i < 48; ++i) {
      const int column = i / 8;
      world.create_body(at(column * .41, (i % 8 - 3.5) * .41), Shape::box({real(.2), real(.2)}), wood);
    }
    EXPECT_LT(deepest(world, 40), static_cast<double>(tolerated_sink)) << solver;
  }
}

// A ball at 8 m/s drives bricks through each other that one step of a large pile, with its normals as they were, lets
// through: 7 mm when such a step was not done again.
TEST(Turning, AWallThatABallBreaksIsSteppedAgainWhereItGotDeep) {
  const Material brick{real(6.25), real(.13), real(.13), 0};
  for (const char* solver : {"accurate", "accurate-scalar"}) {
    Settings settings = falling();
    settings.solver = solver;
    World world(settings);
    add_floor(world, brick);
    for (int i = 0; i < 108; ++i) {
      const int row = i / 12;
      const double x = .3783 * (i % 12) + (row % 2 == 0 ? 0 : .18915);
      world.create_body(at(x, .20025 + .4005 * row), Shape::box({real(.18415), real(.20025)}), brick);
    }
    world.create_body(at(-1.5, .8734, 8.2544, -.7369), Shape::circle(real(.25)), brick);
    EXPECT_LT(deepest(world, 40), static_cast<double>(tolerated_sink)) << solver;
  }
}

/// Boxes of .5 m, each row beside the one below, and a disc that comes from the left.
World struck(int rows, int columns, double speed, double density) {
  const Material rough{1, real(.5), real(.5), 0};
  World world(falling());
  add_floor(world, rough);
  for (int i = 0; i < columns * rows; ++i) {
    const int row = i / columns;
    const double x = .5 * (i % columns) + (row % 2 == 0 ? 0 : .125);
    world.create_body(at(x, .5 * row + .25), Shape::box({real(.25), real(.25)}), rough);
  }
  const Material heavy{real(density), real(.5), real(.5), 0};
  world.create_body(at(-2.5, .25 * rows, speed), Shape::circle(1), heavy);
  return world;
}

// While blows go through an island, what overlaps is pushed apart as at any other time: .86 mm deep when it was not.
TEST(Turning, ATowerThatIsKnockedDownOverlapsNoMoreThanOneThatStands) {
  World world = struck(40, 1, 6, 1);
  EXPECT_LT(deepest(world, 120), static_cast<double>(tolerated_sink));
}

// When a wall has come to rest, what single corners bear says how many sub-steps it needs: .58 mm deep when only its
// weight did.
TEST(Turning, AWallThatHasBeenKnockedDownOverlapsNoMoreThanOneThatStands) {
  World world = struck(8, 8, 2, 4);
  EXPECT_LT(deepest(world, 120), static_cast<double>(tolerated_sink));
}

// With fast spin, other corners come near within a step.
TEST(Turning, SpinningBoxesCollideWithTheCornersAtThatTime) {
  Settings settings;
  settings.gravity = {};
  World world(settings);
  for (int i = 0; i < 8; ++i) {
    world.create_body(at(.5 * i, .1 * (i % 3), i < 4 ? 3 : -3, 0), Shape::box({real(.15), real(.15)}), wood);
    Body box = world.body(world.bodies().back());
    box.set_velocity(box.velocity(), real(i % 2 == 0 ? 18 : -13));
  }
  EXPECT_LT(deepest(world, 60), static_cast<double>(tolerated_sink));
}

// A corner that meets first throws the next one down, which may be the only one near by then, or one more: up to 44 mm
// deep when contacts kept as many points within a step as they had.
TEST(Turning, FallingBoxesCollideWithAllCornersThatComeNear) {
  const Material tough{1, real(.5), real(.5), real(.2)};
  for (const unsigned seed : {75U, 582U, 820U, 882U, 906U}) {
    RandomShapes random(seed);
    World world{Settings{}};
    add_floor(world, tough);
    for (int i = 0; i < 4; ++i) {
      BodyDef box = at(random.number(-.1, .1), 1 + 1.2 * i);
      box.angle = random.number(0, 1.5);
      const Real half = random.number(.2, .35);
      world.create_body(box, Shape::box({half, half}), tough);
    }
    EXPECT_LT(deepest(world, 90), static_cast<double>(tolerated_sink)) << seed;
  }
}

// Too many to pass a blow through all of them, but normals and arms follow them: 8 cm deep when those stood still.
// Bodies deeper than deep_overlap are pushed apart, which takes energy.
TEST(Turning, AHeapOfFallingBoxesOverlapsByMillimetres) {
  const Material tough{1, real(.5), real(.5), real(.2)};
  RandomShapes random(1);
  World world{Settings{}};
  add_floor(world, tough);
  for (const double x : {-2.5, 2.5}) {
    BodyDef wall = at(x, 5);
    wall.type = BodyType::fixed;
    world.create_body(wall, Shape::box({real(.2), 5}), tough);
  }
  for (int i = 0; i < 120; ++i) {
    const int row = i / 6;
    BodyDef box = at(-1.75 + .7 * (i % 6) + random.number(-.05, .05), 1 + .6 * row, 0, -6);
    box.angle = random.number(0, 1.5);
    world.create_body(box, Shape::box({random.number(.1, .2), random.number(.1, .2)}), tough);
  }
  EXPECT_LT(deepest(world, 80), static_cast<double>(deep_overlap));
}

// 2/3 g/r sin a about the edge, too slowly to be followed within a step: 3 % off when the contact was kept for 10 mm.
TEST(Turning, ADiscThatTurnsSlowlyAboutAnEdgeHasTheNormalOfEachStep) {
  constexpr double angle = .276;
  constexpr double radius = .5;
  const Material rough{1, 2, 2, 0};
  Settings settings;
  settings.gravity = {0, -10};
  World world(settings);
  BodyDef step = at(2, .05);
  step.type = BodyType::fixed;
  world.create_body(step, Shape::box({2, real(.05)}), rough);
  constexpr double start = -.3;  // rad/s
  BodyDef def = at(-radius * std::sin(angle), .1 + radius * std::cos(angle), -radius * start * std::cos(angle),
                   -radius * start * std::sin(angle));
  def.angular_velocity = real(start);
  const BodyId disc = world.create_body(def, Shape::circle(real(radius)), rough);
  double a = angle;
  double w = start;
  constexpr int steps = 10;
  for (int i = 0; i < 1000 * steps; ++i) {
    w += 2.0 / 3 * 10 / radius * std::sin(a) / 60000;
    a += w / 60000;
  }
  run(world, steps);
  EXPECT_NEAR(static_cast<double>(world.body(disc).angular_velocity()), w, .005 * (w - start));
}

// Friction of a coefficient above 4/3 turns the tip of a slender rod into the ground that it slides on (Painleve 1895).
TEST(Turning, ARodThatFrictionRotatesIntoTheGroundDoesNotPenetrate) {
  World world{Settings{}};
  add_floor(world, {1, 2, 2, 0});
  const double lean = 1.012;  // rad, where friction of 2 turns it in most
  const double half = 1;
  const double thin = .01;
  BodyDef def = at(-half * std::cos(lean), half * std::sin(lean) + thin * std::cos(lean), 5, 0);
  def.angle = real(-lean);
  world.create_body(def, Shape::box({real(half), real(thin)}), {1, 2, 2, 0});
  EXPECT_LT(deepest(world, 120), static_cast<double>(tolerated_sink));
}

// All of the load is on one corner, which must end up on the surface.
TEST(Turning, ABoxThatLeansOnACornerDoesNotStayInTheGround) {
  World world{Settings{}};
  add_floor(world, wood);
  world.create_body(at(0, .25), Shape::box({real(.05), real(.25)}), {200, real(.9), real(.9), 0});
  BodyDef leaning = at(.36, .36);
  leaning.angle = real(.6);
  world.create_body(leaning, Shape::box({real(.05), real(.4)}), {200, real(.9), real(.9), 0});
  for (int i = 0; i < 300; ++i) world.step();
  EXPECT_LT(deepest(world, 1), 1e-4);
}

// Each body's momentum changes by the reported impulses along the reported normals, even if these rotated.
// A plank that spins past a fixed disc comes near it with another side than the one that was near at the start of the
// step, of which only the plane, far beyond the side's end, would be hit.
TEST(Turning, APlankThatSpinsPastADiscDoesNotHitIt) {
  Settings settings;
  settings.gravity = {};
  World world(settings);
  BodyDef post = at(real(.8), 1);
  post.type = BodyType::fixed;
  world.create_body(post, Shape::circle(real(.2)));
  BodyDef def = at(real(.6), 0);
  def.velocity = {0, 2};
  const BodyId plank = world.create_body(def, Shape::box({real(.5), real(.15)}));
  world.add_force(ConstantForce{plank, {}, 6});
  run(world, 9);
  EXPECT_EQ(world.body(plank).velocity(), (Vec2{0, 2}));
}

/// Bodies' velocities a step later by what contacts report, and what the world makes of them.
struct Ledger {
  std::vector<Vec2> reported, real;
  std::vector<Real> given;  // N s, by all contacts of a body
};

Ledger ledger(World& world) {
  Ledger ledger;
  const std::span<const BodyId> all = world.bodies();
  for (const BodyId id : all) ledger.reported.push_back(world.body(id).velocity());
  ledger.given.resize(all.size());
  world.step();
  const auto give = [&](BodyId id, Vec2 impulse) {
    const Body body = world.body(id);
    if (body.type() == BodyType::fixed) return;
    const auto index = static_cast<std::size_t>(std::find(all.begin(), all.end(), id) - all.begin());
    ledger.reported[index] += impulse / body.mass().mass;
    ledger.given[index] += length(impulse);
  };
  for (const ContactInfo& contact : world.contacts()) {
    const Vec2 impulse =
        contact.normal_impulse * contact.normal + contact.tangent_impulse * perpendicular(contact.normal);
    give(contact.a, -impulse);
    give(contact.b, impulse);
  }
  for (const BodyId id : all) ledger.real.push_back(world.body(id).velocity());
  return ledger;
}

TEST(Turning, ReportsTheNormalAlongWhichContactsActed) {
  Settings settings;
  settings.gravity = {};
  World world(settings);
  for (int i = 0; i < 6; ++i) {
    world.create_body(at(.35 * i, .1 * (i % 3), i < 3 ? 2 : -2, 0), Shape::box({real(.15), real(.15)}), wood);
    Body box = world.body(world.bodies().back());
    box.set_velocity(box.velocity(), real(i % 2 == 0 ? 9 : -7));
  }
  Real given = 0;
  for (int step = 0; step < 60; ++step) {
    const Ledger now = ledger(world);
    for (std::size_t i = 0; i < now.real.size(); ++i) {
      given += now.given[i];
      // Pushes along several normals add up to less than their sum: of 9 rad/s in a step, (w dt)^2/24.
      EXPECT_LT(length(now.real[i] - now.reported[i]), real(.01)) << "box " << i << ", step " << step;
    }
  }
  EXPECT_GT(given, 0);
}

TEST(Turning, GivesDiscsWhatTheirContactsReport) {
  Settings settings;
  settings.gravity = {};
  World world(settings);
  for (int i = 0; i < 36; ++i) {
    const int row = i / 6;
    const double x = i % 6 - 2.5;
    const double y = row - 2.5;
    world.create_body(at(.21 * x, .23 * y, -2 * x, -3 * y, i % 5 - 2), Shape::circle(real(.1)),
                      {1, real(.4), real(.4), real(.2)});
  }
  Real given = 0;
  for (int step = 0; step < 60; ++step) {
    const Ledger now = ledger(world);
    for (std::size_t i = 0; i < now.real.size(); ++i) {
      given += now.given[i];
      const Real mass = world.body(world.bodies()[i]).mass().mass;
      EXPECT_LT(length(now.real[i] - now.reported[i]), 256 * round_off * (10 + now.given[i] / mass))
          << "disc " << i << ", step " << step;
    }
  }
  EXPECT_GT(given, 0);
}

// The plane of a face of a body that turns sweeps over others: those that something struck may throw at it have
// contacts .8 m away. Too many for a small island.
TEST(Turning, LetsNoPlaneOfAFacePushWhatIsFarFromIt) {
  Settings settings;
  settings.gravity = {};
  World world(settings);
  add_floor(world, frictionless());
  const auto disc = [](double radius, double x, double y, double e = 0) {
    return Part{Shape::circle(real(radius), {real(x), real(y)}), frictionless(e)};
  };
  const auto box = [](double width, double height, Vec2 center, double angle, double e) {
    return Part{Shape::box({real(width / 2), real(height / 2)}, center, real(angle)), frictionless(e)};
  };
  BodyDef post = at(2.1, -.015, 0, 0, 0, 2.3);
  post.type = BodyType::fixed;
  world.create_body(post, Shape::circle(real(.22), {real(.22), real(-.11)}), frictionless());
  const std::array rising{disc(.13, -.066, .15)};
  world.create_body(at(2.4, .85, 0, 3, 0, 1.5), rising);
  const std::array still{disc(.16, .15, .28), disc(.12, .32, .32)};
  world.create_body(at(.58, .51, 0, 0, 0, -1.6), still);
  const std::array passing{box(.24, .17, {real(.23), real(-.062)}, 1.2, 1), disc(.1, -.15, -.14)};
  world.create_body(at(1.6, .31, 2.8, 0, -10, 1.2), passing);
  const std::array far{disc(.1, -.04, .2, 1), disc(.07, .1, -.2, 1), disc(.04, -.02, .1)};
  const BodyId apart = world.create_body(at(.9, .7, 0, 0, 0, .3), far);
  const std::array turning{disc(.0491, .124, .117), disc(.0522, -.0793, -.0492),
                           box(.126, .0911, {real(-.0709), real(.0622)}, -.337, 0)};
  const BodyId spinning = world.create_body(at(1.46, 1.36, 2.17, 7.24, 91.7), turning);
  world.step();
  EXPECT_EQ(world.body(apart).velocity(), Vec2{});
  EXPECT_EQ(world.body(apart).angular_velocity(), 0);
  EXPECT_EQ(world.body(spinning).angular_velocity(), real(91.7));
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::turning_test
