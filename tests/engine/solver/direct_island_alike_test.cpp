// Small islands move alike in scenes that say the same: turned, listed otherwise, of another size, with more that is
// far.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../support.h"
#include "bodies/body_set.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::direct_island_alike_test {
namespace {

constexpr double rounding = 1e4 * static_cast<double>(round_off);

BodyDef fixed(BodyDef def) {
  def.type = BodyType::fixed;
  return def;
}

// A capsule that is thrown back by a wall might hit a box that turns, if it were nearer. Whether it is near must not be
// said by bounds: where both are one island, the capsule's impact divides the step of the damped box, too.
TEST(DirectIsland, OfWhatMayBeHitIsTheSameInAnyDirection) {
  std::vector<Real> turning;
  for (const double angle : {0., .7, 1.5, 2.2, 4.}) {
    const Rotation turn(real(angle));
    World world(falling(0));
    BodyDef def = fixed(at(0, 0, 0, 0, 0, angle));
    world.create_body(def, Shape::half_space({-1, 0}, real(-1.2)), frictionless());
    def = at(0, 0, 0, 0, -11, angle);
    def.position = turn * Vec2{real(.78), real(.39)};
    def.velocity = turn * Vec2{real(3.1), 0};
    world.create_body(def, Shape::capsule({real(-.22), 0}, {real(.22), 0}, real(.18)), frictionless(1));
    def = at(0, 0, 0, 0, -2, angle + .6);
    def.position = turn * Vec2{real(-.6), real(.3)};
    def.angular_damping = 2;
    const BodyId box = world.create_body(def, Shape::box({real(.25), real(.25)}), frictionless());
    world.step();
    turning.push_back(world.body(box).angular_velocity());
  }
  for (const Real w : turning) EXPECT_NEAR(w, turning[0], rounding);
}

// Four discs in a row, welded to each other, come down on an elastic floor with one end. An elastic impact does no
// work, but for what mends the rounding of welds, and that must not be taken for work that restitution does: nothing
// would rebound then.
TEST(DirectIsland, OfWeldedBodiesReboundsWhereverTheyAre) {
  std::vector<Real> rising;
  const double w = 1.2125;
  for (int place = 0; place < 24; ++place) {
    const double x = .7 * place;
    World world(falling());
    world.create_body(fixed(at(x, 0)), Shape::half_space({0, 1}, 0), frictionless(1));
    const auto disc = [&](const BodyDef& def, double radius, double density) {
      return world.create_body(def, Shape::circle(real(radius)), {real(density), 0, 0, 0});
    };
    const BodyId light = disc(at(x - .74576, .21922, 1.2892, -1.1043, w), .1892, .5339);
    const BodyId right = disc(at(x + 1.149, .48697, .96458, 1.1931, w), .35, 2.853);
    const BodyId left = disc(at(x - 1.4266, 2.0003, -.87028, -1.9298, w), .30443, 3.668);
    const BodyId high = disc(at(x + 1.2969, 1.8071, -.63975, 1.3662, w), .15, 6.093);
    world.create_joint(WeldJoint{right, light, {real(x + .20162), real(.3531)}});
    world.create_joint(WeldJoint{light, left, {real(x - 1.0862), real(1.1098)}});
    world.create_joint(WeldJoint{left, high, {real(x - .064895), real(1.9037)}});
    run(world, 2);
    rising.push_back(world.body(light).velocity().y);
  }
  for (const Real v : rising) {
    EXPECT_GT(v, 0);
    EXPECT_NEAR(v, rising[0], 100 * rounding);
  }
}

// A polygon turns so fast that another of its corners meets the capsule within the step. The disc behind it is fixed,
// too, but does not go on where the capsule ends: no ghost collision can come from there.
TEST(DirectIsland, BetweenFixedShapesThatDoNotJoinSeesCornersComeRound) {
  const std::vector<Vec2> corners{{real(.0837), real(.0795)},  {real(.00133), real(.115)},  {real(-.107), real(.0425)},
                                  {real(-.0781), real(-.085)}, {real(.00175), real(-.115)}, {real(.108), real(-.0413)}};
  std::vector<Body> polygons;
  std::vector<World> worlds(2, World(falling(0)));
  for (World& world : worlds) {
    if (&world == &worlds[1]) {
      world.create_body(fixed(at(1, .5)), Shape::circle(real(.1)), frictionless());
    }
    const Shape capsule = Shape::capsule({real(-.11), 0}, {real(.11), 0}, real(.24));
    world.create_body(fixed(at(.13, .6)), capsule, frictionless());
    const BodyDef def = at(.619, .531, -2.96, 0, 22, 2.56);
    polygons.push_back(world.body(world.create_body(def, Shape::polygon(corners), frictionless())));
    world.step();
  }
  EXPECT_LT(polygons[0].angular_velocity(), 22);
  EXPECT_EQ(polygons[1].position(), polygons[0].position());
  EXPECT_EQ(polygons[1].velocity(), polygons[0].velocity());
  EXPECT_EQ(polygons[1].angular_velocity(), polygons[0].angular_velocity());
}

// A box lands flat on a door that its hinge's stop has just caught. Far from the origin the gaps of its corners are
// rounded differently, by more than what touches near it.
TEST(DirectIsland, LandsABoxFlatOnADoorWhereverItsHingeIs) {
  const auto landed = [](double x, double y) {
    Settings settings = falling();
    settings.gravity = vec(.703, -10);
    World world(settings);
    BodyDef def = tilted(x, y, 0);
    def.type = BodyType::fixed;
    const BodyId post = world.create_body(def, Shape::circle(real(.05)));
    def = at(x + .8686, y, 0, -2.3257633600000003, -2.6776);
    const BodyId door = world.create_body(def, Shape::box({real(.8686), real(.13545)}), frictionless());
    def = at(x + 1.53377388, y + .9607, 0, -.387);
    const BodyId box = world.create_body(def, Shape::box({real(.21574), real(.21574)}), frictionless());
    world.create_joint(
        RevoluteJoint{.a = post, .b = door, .anchor = vec(x, y), .limits = Limits{real(-.0255), real(.7919)}});
    world.add_force(ConstantForce{.body = door, .torque = real(9.0861)});
    run_for(world, 1);
    return world.body(box).position() - vec(x, y);
  };
  const Vec2 here = landed(0, 0);
  for (int place = 1; place < 20; ++place) {
    const Vec2 away = vec(.37 * place, -.21 * place);
    const Vec2 there = landed(static_cast<double>(away.x), static_cast<double>(away.y));
    const double farthest = 2 + static_cast<double>(length(away));  // m, of a coordinate
    constexpr double grows = 200;  // what is rounded where it lands, in a second after it
    EXPECT_LT(static_cast<double>(length(there - here)), grows * static_cast<double>(round_off) * farthest) << place;
  }
}

// A plank that falls on its end, 3e-4 rad from upright, hits with one corner and spins; only what is flatter than any
// motion tells is struck with both.
TEST(DirectIsland, StrikesOneCornerOfAPlankThatIsNotQuiteUpright) {
  World world(falling(0));
  add_floor(world, frictionless(.15));
  const double half = .05;
  const Shape shape = Shape::box({real(half), real(.8)});
  const BodyId plank = world.create_body(at(0, .85, 0, -5, 0, 3e-4), shape, frictionless(.15));
  const MassData mass = world.body(plank).mass();
  for (int step = 0; step < 2; ++step) world.step();
  const double arm = half * std::cos(3e-4) - .8 * std::sin(3e-4);
  const double m = static_cast<double>(mass.mass);
  const double inertia = static_cast<double>(mass.inertia);
  const double impulse = 1.15 * 5 / (1 / m + arm * arm / inertia);
  EXPECT_NEAR(std::abs(static_cast<double>(world.body(plank).angular_velocity())), impulse * arm / inertia, 1e-4);
}

// A polygon lands on two corners, one of them a hundredth lower than the other: as two impacts, of whatever size it is.
TEST(DirectIsland, IsTheSameInAnyUnitOfLength) {
  std::vector<double> heights;
  for (const double size : {1., 4., 16.}) {
    const auto corner = [size](double x, double y) { return Vec2{real(size * x), real(size * y)}; };
    Settings settings = falling();
    settings.dt *= real(std::sqrt(size));
    World world(settings);
    add_floor(world, frictionless());
    const std::vector<Vec2> corners{corner(.01, -.008), corner(.0065, .011), corner(-.012, .0059),
                                    corner(-.01, -.0082)};
    const BodyDef def = at(0, .022 * size, 0, -std::sqrt(size));
    const BodyId body = world.create_body(def, Shape::polygon(corners), frictionless(1));
    world.step();
    heights.push_back(static_cast<double>(world.body(body).position().y) / size);
  }
  EXPECT_NEAR(heights[1], heights[0], rounding);
  EXPECT_NEAR(heights[2], heights[0], rounding);
}

// A torque would turn the disc, were it free, by 181 radians in the first sub-step. Its hinge is as well kept after any
// number of whole turns, but it moves as far as the hinge lets it.
TEST(DirectIsland, TurnsAHingedBodyByNoMoreThanItsForcesDo) {
  World world(falling(0));
  const BodyId post = world.create_body(fixed(at(0, 0)), Shape::circle(real(.05)), frictionless());
  const BodyId door =
      world.create_body(at(.62704, .057276, -.11184, 1.2244, 1.9526), Shape::circle(real(.0269)), frictionless());
  world.create_body(fixed(at(.7, .4)), Shape::circle(real(.3)), frictionless());
  world.create_joint(RevoluteJoint{.a = post, .b = door});
  world.add_force(ConstantForce{.body = door, .torque = real(17.164)});
  for (int step = 0; step < 20; ++step) {
    world.step();
    const Body now = world.body(door);
    const double turned = std::atan2(static_cast<double>(now.position().y), static_cast<double>(now.position().x)) -
                          std::atan2(.057276, .62704);
    ASSERT_NEAR(static_cast<double>(now.angle()), turned, 1e-4) << step;
  }
}

// A box meets a polygon .1 ns after that has touched the ground. What rounding makes of a gap is a speed of micrometres
// a second in so short an interval, which friction must not keep: elsewhere the rounding is another.
TEST(DirectIsland, KeepsNoSpeedThatRoundingMakesInAShortInterval) {
  const std::vector<Vec2> corners{{real(-.3), real(.1)}, {real(-.04), real(-.3)}, {real(.3), real(.1)}};
  const Material rough{1, 1, 1, 0};
  std::vector<Velocity> velocities;
  for (const Vec2 origin : {Vec2{}, Vec2{real(4.524546940265137), real(1.6220073936799548)}}) {
    World world(falling());
    const auto moved = [&](BodyDef def) {
      def.position += origin;
      return def;
    };
    world.create_body(moved(fixed(at(0, 0))), Shape::half_space({0, 1}, 0), rough);
    const BodyDef def = at(.076659, .1663, .44713, 0, 0, -.85652);
    const BodyId polygon = world.create_body(moved(def), Shape::polygon(corners), rough);
    world.create_body(moved(at(-.25584, .12018, 1.3528, .78178, -10.401, 1.3407)), Shape::box({real(.1), real(.1)}),
                      frictionless());
    world.create_body(moved(at(-1, .5)), Shape::circle(real(.4)), frictionless());
    world.step();
    velocities.push_back({world.body(polygon).velocity(), world.body(polygon).angular_velocity()});
  }
  EXPECT_NEAR(velocities[1].w, velocities[0].w, 1e6 * static_cast<double>(round_off));
  EXPECT_NEAR(length(velocities[1].v - velocities[0].v), 0, 1e6 * static_cast<double>(round_off));
}

/// Four bodies that come near each other at few places, of the 31 at which the blow that throws one of them up may
/// bring them together.
std::vector<Vec2> thrown(bool backwards) {
  World world(falling());
  const auto disc = [](double x, double y, double radius, double restitution = 0) {
    return Part{Shape::circle(real(radius), {real(x), real(y)}), frictionless(restitution)};
  };
  struct Listed {
    BodyDef def;
    std::vector<Part> parts;
  };
  std::vector<Listed> bodies{
      {fixed(at(0, 0)), {{Shape::half_space({0, 1}, 0), frictionless()}}},
      {fixed(at(.53241, .6948, 0, 0, 0, 1.4358)),
       {{Shape::box({real(.25), real(.084125)}, {real(-.3787), real(-.0894)}, real(1.037)), frictionless()}}},
      {at(1.7, .23, 0, -8.4, 0, .38), {disc(.21, .12, .35, 1)}},
      {at(1.3, .63, 0, 0, 0, -2.4), {{Shape::box({real(.25), real(.15)}, {real(.36), real(-.31)}), frictionless(1)}}},
      {fixed(at(-.6, .7)), {disc(-.03, .1, .04)}},
      {at(-.08, .7), {disc(.1, -.03, .04), disc(-.1, .03, .05), disc(-.01, -.1, .05)}},
      {at(.65568, .13168, 0, 0, 0, .63977), {disc(-.0486, -.0518, .061107), disc(-.0778, .0374, .046837)}}};
  if (backwards) std::reverse(bodies.begin(), bodies.end());
  std::vector<BodyId> ids;
  ids.reserve(bodies.size());
  for (const Listed& body : bodies) ids.push_back(world.create_body(body.def, body.parts));
  if (backwards) std::reverse(ids.begin(), ids.end());
  world.step();
  std::vector<Vec2> places;
  places.reserve(ids.size());
  for (const BodyId id : ids) places.push_back(world.body(id).position());
  return places;
}

TEST(DirectIsland, OfFewThatComeNearIsTheSameInEitherOrder) {
  const std::vector<Vec2> first = thrown(false);
  const std::vector<Vec2> then = thrown(true);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(length(then[i] - first[i]), 0, rounding) << i;
}

/// m, where a box is that the corner of a turning drum has carried round for a while.
Vec2 carried_round(bool backwards) {
  World world(falling());
  const auto add_box = [&world] {
    BodyDef def = at(.1375, .5215, .7286, -.6973, 0, .0992);
    def.linear_damping = real(1.8185);
    return world.create_body(def, Shape::box({real(.10192), real(.054815)}), {real(.8139), 1, 1, 0});
  };
  const Material rough{1, real(.3302), real(.3302), 0};
  std::vector<Part> walls;
  for (const double side : {1., -1.}) {
    walls.push_back({Shape::box({real(.2), real(1.1695)}, {real(1.3695 * side), 0}), rough});
    walls.push_back({Shape::box({real(1.5695), real(.2)}, {0, real(1.3695 * side)}), rough});
  }
  if (backwards) std::reverse(walls.begin(), walls.end());
  BodyDef drum;
  drum.type = BodyType::kinematic;
  drum.angular_velocity = real(-2.9254);
  BodyId box;
  if (backwards) box = add_box();
  world.create_body(drum, walls);
  if (!backwards) box = add_box();
  for (int step = 0; step < 80; ++step) world.step();
  return world.body(box).position();
}

// The corner holds the box by two contacts of which both stick: four laws of three velocities, which the turn of the
// drum within an interval contradicts. How the contacts share the load must not be what rounding makes of that.
TEST(DirectIsland, CarriesABoxRoundInACornerAlikeInEitherOrder) {
  const double off = static_cast<double>(length(carried_round(true) - carried_round(false)));
  EXPECT_LT(off, 1e5 * static_cast<double>(round_off));
}

/// m, where a plate is after a step on a polygon that shoots out from under it; x of the mirrored scene is negated.
Vec2 shot_out_under_a_plate(bool mirrored) {
  const Real side = mirrored ? Real{-1} : Real{1};
  World world(falling());
  add_floor(world, frictionless());
  std::vector<Vec2> corners{{real(.0279), real(.0416)},   {real(-.0011), real(.0501)}, {real(-.045), real(.022)},
                            {real(-.0501), real(-.0018)}, {real(-.0273), real(-.042)}, {real(.0052), real(-.0498)},
                            {real(.0405), real(-.0295)},  {real(.049), real(.0105)}};
  for (Vec2& corner : corners) corner.x *= side;
  BodyDef def = at(-.93, .0447, -14.2, 0, 0, 1.055);
  const auto mirror = [side](BodyDef of) {
    of.position.x *= side;
    of.velocity.x *= side;
    of.angle *= side;
    of.angular_velocity *= side;
    return of;
  };
  world.create_body(mirror(def), Shape::polygon(corners), frictionless());
  def = at(-.84, .156, -1.13, -.5, 2.42, -.0515);
  const BodyId plate = world.create_body(mirror(def), Shape::box({real(.9063), real(.0676)}), frictionless());
  world.step();
  return {side * world.body(plate).position().x, world.body(plate).position().y};
}

// Of two points that a contact has, the nearer one tells what it has not reached yet, whichever comes first.
TEST(DirectIsland, LetsAPlateDownAlikeOnEitherSide) {
  EXPECT_NEAR(length(shot_out_under_a_plate(true) - shot_out_under_a_plate(false)), 0, rounding);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::direct_island_alike_test
