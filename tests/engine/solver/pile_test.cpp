// Piles solved eight contacts at a time against the same contacts solved one by one.
#include "solver/pile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../random_shapes.h"
#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::pile_test {

namespace {

Settings with(const char* solver) {
  Settings settings;
  settings.solver = solver;
  return settings;
}

/// No pile is cached while a callback sees each contact.
void see_contacts(World& world) {
  world.set_pre_solve([](PreSolveContact&) {});
}

const Material rough{1, real(.6), real(.5), 0};

World pyramid(const Settings& settings, Real nudge) {
  World world(settings);
  see_contacts(world);
  add_floor(world, rough);
  for (int row = 0; row < 12; ++row) {
    for (int i = 0; i < 12 - row; ++i) {
      world.create_body(at(1.01 * i + .5 * row, .5 + row), Shape::box({real(.5), real(.5)}), rough);
    }
  }
  Body top = world.body(world.bodies().back());
  top.set_velocity({nudge, 0}, 0);
  return world;
}

/// Bodies in a turning drum, some of which it carries along.
World drum(const Settings& settings, Real nudge, bool discs) {
  World world(settings);
  see_contacts(world);
  BodyDef def;
  def.type = BodyType::kinematic;
  def.angular_velocity = real(.7);
  std::vector<Part> walls;
  for (int i = 0; i < 4; ++i) {
    const Rotation q(static_cast<Real>(i) * pi / 2);
    walls.push_back({Shape::box({6, real(.5)}, q * Vec2{0, real(-5.5)}, static_cast<Real>(i) * pi / 2), rough});
  }
  world.create_body(def, walls);
  RandomShapes random(5);
  // So many that islands are not small in the sense of `accurate`.
  constexpr int side = 16;
  constexpr double pitch = 10.0 / side;
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side;
    BodyDef body = at(pitch * (i % side + .5) - 5, pitch * (row + .5) - 4.95);
    body.position.x += nudge;
    body.angle = random.number(-.2, .2);
    const Real size = real(pitch) * random.number(.42, .45);
    world.create_body(body, discs ? Shape::circle(size) : Shape::box({size, size * real(.9)}), rough);
  }
  return world;
}
World drum_of_boxes(const Settings& settings, Real nudge) { return drum(settings, nudge, false); }
World drum_of_discs(const Settings& settings) { return drum(settings, 0, true); }

/// A plank with more bodies on it than there are colours.
World crowded_plank(const Settings& settings, Real nudge) {
  World world(settings);
  see_contacts(world);
  add_floor(world, rough);
  world.create_body(at(0, .5), Shape::box({60, real(.5)}), {20, real(.6), real(.5), 0});
  for (int i = 0; i < 100; ++i) {
    BodyDef def = at(1.1 * i - 54, 1.4 + .01 * (i % 7));
    def.velocity.x = nudge;
    world.create_body(def, i % 2 == 0 ? Shape::circle(real(.4)) : Shape::box({real(.4), real(.4)}), rough);
  }
  return world;
}

/// Frictionless discs in hexagonal packing, overlapping by 1 mm, between walls.
World well_of_smooth_discs(const Settings& settings) {
  World world(settings);
  see_contacts(world);
  add_floor(world, frictionless());
  BodyDef wall;
  wall.type = BodyType::fixed;
  for (const double side : {-1, 1}) {
    wall.position = {real(5.495 * side), 5};
    world.create_body(wall, Shape::box({real(.5), 5}), frictionless());
  }
  constexpr double pitch = .999;
  for (int row = 0; row < 10; ++row) {
    for (int i = 0; i < 10 - row % 2; ++i) {
      const BodyDef def = at(pitch * (i - 4.5 + .5 * (row % 2)), .5 + pitch * row * std::sqrt(.75));
      world.create_body(def, Shape::circle(real(.5)), frictionless());
    }
  }
  return world;
}

/// The largest difference of a coordinate (m) or speed (m/s) after some steps.
Real difference(World a, World b, int steps) {
  run(a, steps);
  run(b, steps);
  Real worst = 0;
  for (const BodyId id : a.bodies()) {
    const Vec2 apart = a.body(id).position() - b.body(id).position();
    const Vec2 speed = a.body(id).velocity() - b.body(id).velocity();
    worst = std::max({worst, length(apart), length(speed)});
  }
  return worst;
}

struct Pileup {
  const char* name;
  World (*make)(const Settings&, Real nudge);
  int steps;
};

class Piles : public testing::TestWithParam<Pileup> {};

// Rounding differs in each of the some thousand operations on the way to a velocity, and a scene makes it grow as it
// does a nudge of the one body or coordinate that it is given at the start, in units of rounding at 10 m.
TEST_P(Piles, AgreeWithTheScalarSolverUpToTheGrowthOfRounding) {
  const Pileup& pile = GetParam();
  const Real nudge = 10 * std::numeric_limits<Real>::epsilon();
  const Settings scalar = with("accurate-scalar");
  const Real growth = difference(pile.make(scalar, 0), pile.make(scalar, nudge), pile.steps);
  EXPECT_GT(growth, 0);
  EXPECT_LE(growth, 1e4F * nudge) << "chaos proves nothing: fewer steps";
  const Real apart = difference(pile.make(with("accurate"), 0), pile.make(scalar, 0), pile.steps);
  EXPECT_GT(apart, 0) << "not solved as a pile at all";
  EXPECT_LE(apart, 100 * growth);
}

INSTANTIATE_TEST_SUITE_P(All, Piles,
                         testing::Values(Pileup{"Pyramid", pyramid, 60}, Pileup{"DrumOfBoxes", drum_of_boxes, 4},
                                         Pileup{"CrowdedPlank", crowded_plank, 12}),
                         [](const auto& with_name) { return std::string(with_name.param.name); });

// Discs that roll over each other turn their normal within a sub-step, here at the first impacts by 1 m/s / .54 m / 240
// or .0077 of the 1 m/s. One contact at a time, half of the last impulse is given again along the new normal to all
// before any contact is solved; in lanes what lacks of that is given when the contact is solved, so that others see it
// late. And in lanes the half that was given before the drift turns too (ScalarContacts::turn_back has no twin there):
// in each sub-step .0077 of half of what ten layers bear, 10 x 10 m/s^2 / 240 = .4 m/s.
TEST(Piles, OfDiscsAgreeWithTheScalarSolverUpToTheRotationOfNormalsInASubStep) {
  constexpr int steps = 7;
  const Real apart = difference(drum_of_discs(with("accurate")), drum_of_discs(with("accurate-scalar")), steps);
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, real(.0077) + 4 * steps * real(.0077) * real(.4) / 2);
}

// The same of discs that part at up to .23 m/s and bear ten layers, 10 m/s^2 / 480 each: (.23 m/s / 1 m / 480) .21 m/s.
// Later one takes its next number of sub-steps a step before the other.
TEST(Piles, OfFrictionlessDiscsAgreeWithTheScalarSolverUpToTheRotationOfNormalsInASubStep) {
  const Real apart =
      difference(well_of_smooth_discs(with("accurate")), well_of_smooth_discs(with("accurate-scalar")), 3);
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, real(1e-4));
}

// Without friction only rounding could rotate them, and the kernels leave that out too.
TEST(Piles, OfFrictionlessDiscsRotateNothing) {
  World world = well_of_smooth_discs(with("accurate"));
  run(world, 30);
  int borne = 0;
  for (const ContactInfo& contact : world.contacts()) borne += contact.normal_impulse > 0 ? 1 : 0;
  EXPECT_GT(borne, 64) << "no pile";
  for (const BodyId body : world.bodies()) EXPECT_EQ(world.body(body).angular_velocity(), 0);
}

// The normals of colliding discs rotate: impulses applied and removed within a sub-step leave no net impulse.
TEST(Piles, OfDiscsChangeMomentumOnlyByTheReportedImpulses) {
  for (const char* solver : {"accurate", "accurate-scalar"}) {
    Settings settings = with(solver);
    settings.gravity = {};
    World world(settings);
    see_contacts(world);
    for (int i = 0; i < 100; ++i) {
      const int row = i / 10;
      const BodyId disc = world.create_body(at(.45 * (i % 10), .45 * row), Shape::circle(real(.225)), rough);
      // All fall together at first; neighbours pass each other.
      const Vec2 inwards = Vec2{real(2), real(2)} - world.body(disc).position();
      world.body(disc).set_velocity(inwards + real(i % 2 == 0 ? .5 : -.5) * perpendicular(inwards), 0);
    }
    bool some_touched = false;
    int untouched = 0;
    for (int step = 0; step < 60; ++step) {
      std::vector<Vec2> before;
      for (const BodyId disc : world.bodies()) before.push_back(world.body(disc).velocity());
      world.step();
      std::vector<BodyId> touched;
      for (const ContactInfo& contact : world.contacts()) {
        if (contact.normal_impulse > 0) touched.insert(touched.end(), {contact.a, contact.b});
      }
      some_touched |= !touched.empty();
      for (std::size_t i = 0; i < before.size(); ++i) {
        const BodyId disc = world.bodies()[i];
        if (std::find(touched.begin(), touched.end(), disc) != touched.end()) continue;
        ++untouched;
        const Vec2 change = world.body(disc).velocity() - before[i];
        EXPECT_LT(length(change), 64 * round_off) << solver << ", disc " << i << ", step " << step;
      }
    }
    EXPECT_TRUE(some_touched);
    EXPECT_GT(untouched, 100) << "nothing was looked at";
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::pile_test
