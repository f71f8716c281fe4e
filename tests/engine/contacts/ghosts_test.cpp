#include "contacts/ghosts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::ghosts_test {

namespace {

enum class FloorKind { one_floor, tiles, tiles_of_one_body, segments };
enum class Slider { box, disc, capsule };

constexpr double pitch = .5;  // m, of the joins
constexpr int tiles = 44;

Shape slab(double from, double to, double top) {
  return Shape::box({real((to - from) / 2), real(.25)}, {real((from + to) / 2), real(top - .25)});
}

/// A fixed body, or one that moves along x at `drift` m/s.
BodyId add_fixed(World& world, std::span<const Part> parts, double drift = 0) {
  BodyDef def;
  def.type = drift == 0 ? BodyType::fixed : BodyType::kinematic;
  def.velocity = {real(drift), 0};
  return world.create_body(def, parts);
}
void add_fixed(World& world, const Shape& shape, const Material& material) {
  add_fixed(world, std::array{Part{shape, material}});
}

void lay(World& world, FloorKind ground, const Material& material, double drift) {
  if (ground == FloorKind::one_floor) {
    add_floor(world, material);
    return;
  }
  std::vector<Part> parts;
  for (int i = -2; i < tiles; ++i) {
    const double from = i * pitch;
    const double to = from + pitch;
    parts.push_back(
        {ground == FloorKind::segments ? Shape::segment({real(from), 0}, {real(to), 0}) : slab(from, to, 0), material});
  }
  if (ground != FloorKind::tiles) {
    add_fixed(world, parts, drift);
    return;
  }
  for (const Part& part : parts) add_fixed(world, std::array{part}, drift);
}

Shape shape_of(Slider slider) {
  if (slider == Slider::box) return Shape::box({real(.2), real(.2)});
  if (slider == Slider::disc) return Shape::circle(real(.2));
  return Shape::capsule({real(-.2), 0}, {real(.2), 0}, real(.2));
}

/// m/s, along the floor, which moves at `drift` m/s, after 2 s from 10 m/s.
double slid(FloorKind ground, Slider slider, double friction, double dt, double drift = 0) {
  Settings settings;
  settings.dt = real(dt);
  settings.gravity = {0, -10};
  World world(settings);
  const Material material{1, real(friction), real(friction), 0};
  lay(world, ground, material, drift);
  const BodyId body = world.create_body(at(0, .2, real(10 + drift)), shape_of(slider), material);
  run(world, static_cast<int>(std::lround(2 / dt)));
  return static_cast<double>(world.body(body).velocity().x) - drift;
}

}  // namespace

TEST(Ghosts, AreNotHitWhereFixedShapesJoin) {
  for (const Slider slider : {Slider::box, Slider::disc, Slider::capsule}) {
    for (const double friction : {0., .2}) {
      for (const double dt : {1 / 30., 1 / 60., 1 / 240.}) {
        const double alone = slid(FloorKind::one_floor, slider, friction, dt);
        for (const FloorKind ground : {FloorKind::tiles, FloorKind::tiles_of_one_body, FloorKind::segments}) {
          // A rounding of 10 m/s in each of 4 sub-steps' kicks, presses and relaxations.
          EXPECT_NEAR(slid(ground, slider, friction, dt), alone, 12 * 10 * 2 / dt * static_cast<double>(round_off))
              << static_cast<int>(slider) << ' ' << friction << ' ' << dt << ' ' << static_cast<int>(ground);
        }
      }
    }
  }
}

// By rounding at the end of the segment behind, whose plane stands for the one ahead: a disc there fell through a step.
TEST(Ghosts, LetNoDiscFallThatIsOverAJoinAtAStepsStart) {
  for (const double beside : {-64., -1., 0., 1., 64.}) {
    Settings settings;
    settings.gravity = {0, -10};
    World world(settings);
    const Material smooth{1, 0, 0, 0};
    lay(world, FloorKind::segments, smooth, 0);
    const double r = static_cast<double>(round_off);
    const BodyId disc = world.create_body(at(beside * r, .2 + r / 2, 10), Shape::circle(real(.2)), smooth);
    world.step();
    EXPECT_NEAR(static_cast<double>(world.body(disc).position().y), .2, 4 * r) << beside;
  }
}

// The same in a frame in which the floor moves.
TEST(Ghosts, AreNotHitWhereMovingTilesJoin) {
  constexpr double drift = 4;  // m/s
  for (const Slider slider : {Slider::box, Slider::disc, Slider::capsule}) {
    for (const double friction : {0., .2}) {
      const double dt = 1 / 60.;
      const double alone = slid(FloorKind::one_floor, slider, friction, dt);
      for (const FloorKind ground : {FloorKind::tiles, FloorKind::tiles_of_one_body, FloorKind::segments}) {
        EXPECT_NEAR(slid(ground, slider, friction, dt, drift), alone, 12 * 14 * 2 / dt * static_cast<double>(round_off))
            << static_cast<int>(slider) << ' ' << friction << ' ' << static_cast<int>(ground);
      }
    }
  }
}

TEST(Ghosts, LeaveAKerb) {
  World world(Settings{});
  add_fixed(world, slab(-2, 2, 0), frictionless());
  add_fixed(world, slab(2, 4, .01), frictionless());
  BodyDef def = at(0, .2, 5);
  def.fixed_rotation = true;  // otherwise it tips over
  const BodyId body = world.create_body(def, Shape::box({real(.2), real(.2)}), frictionless());
  run(world, 120);
  EXPECT_NEAR(world.body(body).position().x, 1.8, 1e-3);
}

TEST(Ghosts, LeaveAWallOnTheFloor) {
  for (const Slider slider : {Slider::box, Slider::disc, Slider::capsule}) {
    World world(Settings{});
    add_floor(world, frictionless());
    add_fixed(world, Shape::segment({2, 0}, {2, 1}), frictionless());
    const BodyId body = world.create_body(at(0, .2, 5), shape_of(slider), frictionless());
    run(world, 120);
    const Real half_width = world.body(body).parts()[0].shape.bounds({}).high.x;
    EXPECT_NEAR(world.body(body).position().x + half_width, 2, 1e-2) << static_cast<int>(slider);
  }
}

TEST(Ghosts, CollideWithARiseAlongItsOwnNormal) {
  // The component across the rise is lost, which leaves v cos(a). Up by h, v^2 decreases by 2 g h.
  constexpr double angle = .1;
  for (const Slider slider : {Slider::box, Slider::disc}) {
    World world(Settings{});
    const std::array parts{
        Part{Shape::segment({-3, 0}, {1, 0}), frictionless()},
        Part{Shape::segment({1, 0}, {real(1 + 8 * std::cos(angle)), real(8 * std::sin(angle))}), frictionless()}};
    add_fixed(world, parts);
    BodyDef def = at(0, .2, 8);
    def.fixed_rotation = true;
    const BodyId body = world.create_body(def, shape_of(slider), frictionless());
    run(world, 45);
    const Body now = world.body(body);
    const double speed = static_cast<double>(length(now.velocity()));
    const double g = -static_cast<double>(world.settings().gravity.y);
    const double climbed = static_cast<double>(now.position().y) - .2;
    const double left = std::sqrt(std::pow(8 * std::cos(angle), 2) - 2 * g * climbed);
    // The turn is taken at the end of a sub-step, whose gravity along the rise is all lost or gained.
    EXPECT_NEAR(speed, left, 2 * g * angle / 240) << static_cast<int>(slider);
    EXPECT_GT(climbed, .1);
  }
}

TEST(Ghosts, LetABodyFlyOverAnEdgeThatFallsAway) {
  World world(Settings{});
  const std::array parts{Part{Shape::segment({-3, 0}, {1, 0}), frictionless()},
                         Part{Shape::segment({1, 0}, {4, -3}), frictionless()}};
  add_fixed(world, parts);
  const BodyId body = world.create_body(at(0, .2, 8), Shape::circle(real(.2)), frictionless());
  run(world, 20);
  EXPECT_NEAR(world.body(body).velocity().x, 8, 1e-5);
}

TEST(Ghosts, AreRemovedOnlyForThePartAboveAFace) {
  // A hook: one part slides on the table, the other hangs beside it and is stopped by a post below the table's level.
  World world(Settings{});
  add_fixed(world, slab(-4, 0, 0), frictionless());
  add_fixed(world, slab(1, 2, -.5), frictionless());
  const std::array parts{Part{Shape::box({1, real(.1)}, {-1, real(.1)}), frictionless()},
                         Part{Shape::box({real(.1), real(.4)}, {real(.1), real(-.3)}), frictionless()}};
  BodyDef def = at(.01, 0, 2);
  def.fixed_rotation = true;
  const BodyId body = world.create_body(def, parts);
  run(world, 60);
  EXPECT_NEAR(world.body(body).velocity().x, 0, 1e-3);
}

// A polygon spins at 62 rad/s in a corner of a drum, a corner of it a step. What continues a wall makes its contacts
// keep their points for a step; the next wall of a corner does not, or they are 2.4 cm deep.
TEST(Ghosts, KeepNoContactInACornerFromBeingFoundAgain) {
  World world(falling(0));
  BodyDef turning;
  turning.type = BodyType::kinematic;
  turning.angle = real(1.739625);
  turning.angular_velocity = real(2.3195);
  const std::array<Part, 4> walls{Part{Shape::box({real(.2), real(1.5771)}, {real(1.7771), 0})},
                                  Part{Shape::box({real(.2), real(1.5771)}, {real(-1.7771), 0})},
                                  Part{Shape::box({real(1.9771), real(.2)}, {0, real(1.7771)})},
                                  Part{Shape::box({real(1.9771), real(.2)}, {0, real(-1.7771)})}};
  world.create_body(turning, walls);
  const BodyDef def = at(1.65857433, -1.15190663, 5.21279768, 5.69191618, 62.41308854, 2.47878977);
  const std::vector<Vec2> corners{{real(-.10702), real(.02752)}, {real(-.0726), real(-.08331)},
                                  {real(.00672), real(-.1103)},  {real(.08385), real(-.07197)},
                                  {real(.10619), real(.03057)},  {real(.04174), real(.10231)},
                                  {real(-.06504), real(.08933)}};
  world.create_body(def, Shape::polygon(corners));
  for (int step = 0; step < 3; ++step) {
    world.step();
    for (const ContactInfo& contact : world.contacts()) EXPECT_GT(contact.separation, real(-5e-4)) << step;
  }
}

// A box falls past what stands out of a wall, and misses it by 4 mm. Whether the two are a corner, in which contacts
// are found again, must not depend on which point of a contact is listed first: in one of both it was hit by the plane
// of a face, four centimetres from where that ends.
TEST(Ghosts, LetABoxPassWhatStandsOutOfAWallOnEitherSide) {
  for (const double side : {1., -1.}) {
    World world(falling(0));
    const auto fixed = [&](double x, double y, double angle) {
      BodyDef def = at(side * x, y, 0, 0, 0, side * angle);
      def.type = BodyType::fixed;
      return def;
    };
    world.create_body(fixed(0, 0, 1.06), Shape::box({real(.2), real(1.995)}, {real(side * -2.2), 0}), frictionless());
    std::vector<Vec2> corners{{real(-.072), real(.056)},
                              {real(-.064), real(-.065)},
                              {real(.021), real(-.088)},
                              {real(.091), real(.0038)},
                              {real(.012), real(.09)}};
    if (side < 0) {
      for (Vec2& corner : corners) corner.x = -corner.x;
      std::reverse(corners.begin(), corners.end());
    }
    world.create_body(fixed(.71, -2.6, -2.8), Shape::polygon(corners), frictionless());
    const BodyId box = world.create_body(at(side * .59, -2.4, 0, -6.1, 0, side * 1.2),
                                         Shape::box({real(.07), real(.07)}), frictionless());
    world.step();
    EXPECT_NEAR(world.body(box).velocity().y, -6.1, 1e-5) << side;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION::ghosts_test
