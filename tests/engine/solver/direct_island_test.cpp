// Small islands under the default method: see most_direct in accurate.cpp.
#include "solver/direct_island.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../random_shapes.h"
#include "../support.h"
#include "narrow_phase/collide.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::direct_island_test {
namespace {

/// m, what rounding may leave of a gap between bodies within two metres of the origin.
constexpr double rounded_gap = 8 * static_cast<double>(round_off) * 2;

double kinetic(const Body& body) {
  const double v = static_cast<double>(length(body.velocity()));
  const double w = static_cast<double>(body.angular_velocity());
  return static_cast<double>(body.mass().mass) * v * v / 2 + static_cast<double>(body.mass().inertia) * w * w / 2;
}

// A wheel of inertia I that a motor of strength tau brings from rest to the rate w turns by w t - w^2 I/(2 tau),
// whenever in a sub-step that is; a torque that helps it or brakes it shortens or lengthens that.
TEST(DirectIsland, MotorsStopWorkingWhenTheyHaveTheirSpeed) {
  for (const double torque : {0., -3., 30.}) {
    for (int phase = 1; phase <= 20; ++phase) {
      World world(falling());
      BodyDef def;
      def.layers = 0;
      const BodyId wheel = world.create_body(def, Shape::circle(1));
      def.type = BodyType::fixed;
      const BodyId post = world.create_body(def, Shape::circle(real(.1)));
      const double inertia = static_cast<double>(world.body(wheel).mass().inertia);
      const double strength = 10;
      const double takes = .0011 * phase;
      const double speed = (strength + torque) / inertia * takes;
      world.create_joint(RevoluteJoint{.a = post, .b = wheel, .motor = Motor{real(speed), real(strength)}});
      world.add_force(ConstantForce{.body = wheel, .torque = real(torque)});
      world.step();
      world.step();
      const double time = 2 / 60.;
      // Beyond its strength a torque goes on turning the wheel faster.
      const double faster = torque > strength ? (torque - strength) / inertia * (time - takes) : 0;
      const double expected = speed * time - speed * takes / 2 + faster * (time - takes) / 2;
      const double h = 1 / 240.;
      EXPECT_NEAR(static_cast<double>(world.body(wheel).angle()), expected,
                  2 * strength / inertia * std::pow(h / 64, 2) + 1e-12)
          << torque << ' ' << phase;
      EXPECT_NEAR(static_cast<double>(world.body(wheel).angular_velocity()), speed + faster,
                  2 * strength / inertia * h / 64 + 1e-12);
    }
  }
}

// Two light links that carry a heavy load swing past the line between its hinge and theirs at w^2 = 3 T/(m l), T the
// load: 297 rad/s, more than a radian in each sub-step.
TEST(DirectIsland, FollowsLightLinksThatSwingUnderAHeavyLoad) {
  constexpr double aside = 1e-4;  // m: the load hardly rises
  const double angle = std::asin(aside);
  World world(falling());
  BodyDef def;
  def.layers = 0;
  def.type = BodyType::fixed;
  const BodyId post = world.create_body(def, Shape::circle(real(.1)));
  def.type = BodyType::dynamic;
  const auto link = [&](double x, double y, double turned) {
    def.position = {real(x), real(y)};
    def.angle = real(turned);
    return world.create_body(def, Shape::box({real(.005), real(.5)}), {.density = 100});
  };
  const double down = std::cos(angle);  // m, a link reaches
  const BodyId upper = link(aside / 2, -down / 2, angle);
  const BodyId lower = link(aside / 2, -1.5 * down, -angle);
  def.position = {0, real(-2 * down)};
  def.angle = 0;
  const BodyId load = world.create_body(def, Shape::circle(real(.5)), {.density = real(3000 / (.25 * std::acos(-1.)))});
  world.create_joint(RevoluteJoint{.a = post, .b = upper, .anchor = {}});
  world.create_joint(RevoluteJoint{.a = upper, .b = lower, .anchor = {real(aside), real(-down)}});
  world.create_joint(RevoluteJoint{.a = lower, .b = load, .anchor = {0, real(-2 * down)}});
  const double gravity = static_cast<double>(length(falling().gravity));
  const double w = std::sqrt(3 * 3000 * gravity);
  for (int step = 1; step <= 6; ++step) {
    world.step();
    EXPECT_NEAR(static_cast<double>(world.body(upper).angle()), angle * std::cos(w * step / 60), angle * .05) << step;
  }
}

// Housner (1963): a block that lands on its other corner keeps 1 - 1.5 sin^2 a of its spin, whenever in a sub-step that
// is; the corner that it stood on bears it until then.
TEST(DirectIsland, KeepsHousnersShareOfTheSpinOfARockingBlock) {
  const double slenderness = std::atan(.4);
  for (int phase = 0; phase < 20; ++phase) {
    World world(falling());
    const Material rough{1, 2, 2, 0};
    add_floor(world, rough);
    // The second ten strike at .05 to .1 m/s, as slowly as a body falls in a sub-step or two.
    const double tilt = phase < 10 ? .1 + .003 * phase : .0006 + .0002 * (phase - 10);
    const double radius = std::hypot(.4, 1);
    BodyDef def = at(-radius * std::sin(slenderness - tilt), radius * std::cos(slenderness - tilt), 0, 0, 0, tilt);
    const BodyId block = world.create_body(def, Shape::box({real(.4), 1}), rough);
    double before = 0;
    double after = 0;
    for (int i = 0; i < 200 && after == 0; ++i) {
      const double was = static_cast<double>(world.body(block).angle());
      const double energy = kinetic(world.body(block)) + 10 * static_cast<double>(world.body(block).mass().mass) *
                                                             static_cast<double>(world.body(block).position().y);
      world.step();
      const double now = static_cast<double>(world.body(block).angle());
      const double left = kinetic(world.body(block)) + 10 * static_cast<double>(world.body(block).mass().mass) *
                                                           static_cast<double>(world.body(block).position().y);
      if (was > 0 && now < 0) {
        const double flat = 10 * static_cast<double>(world.body(block).mass().mass);
        before = energy - flat;
        after = left - flat;
      }
    }
    const double kept = 1 - 1.5 * std::pow(std::sin(slenderness), 2);
    const double mass = static_cast<double>(world.body(block).mass().mass);
    EXPECT_NEAR(after / before, kept * kept, 1e-4 + 10 * mass * rounded_gap / before) << phase;
  }
}

// A box that falls on a resting one does not hop, whatever the height: restitution is 0.
TEST(DirectIsland, LetsABoxLandOnARestingOneWithoutAHop) {
  const double little = 1e-9 + 2 * rounded_gap;
  for (int drop = 0; drop < 40; ++drop) {
    World world(falling());
    add_floor(world);
    world.create_body(at(0, .5), Shape::box({real(.5), real(.5)}));
    const BodyId upper = world.create_body(at(.1, 1.5 + .05 * drop), Shape::box({real(.5), real(.5)}));
    double highest = 0;
    bool landed = false;
    for (int i = 0; i < 90; ++i) {
      world.step();
      const double height = static_cast<double>(world.body(upper).position().y) - 1.5;
      landed = landed || height < little;
      if (landed) highest = std::max(highest, std::abs(height));
    }
    EXPECT_TRUE(landed) << drop;
    EXPECT_LT(highest, little) << drop;
  }
}

// Pushed one way and then as far back: what is left of both impulses is rounding, and no place is where it acts.
TEST(DirectIsland, ReportsNoContactPointFarFromTheBodies) {
  World world(falling());
  const double tilt = .3490658503988659;
  BodyDef ground = at(0, 0, 0, 0, 0, tilt);
  ground.type = BodyType::fixed;
  world.create_body(ground, Shape::box({30, real(.5)}), Material{1, real(.2), real(.2), 0});
  world.create_body(at(0, 0, 0, 0, 0, tilt), Shape::box({real(.5), real(.5)}), Material{1, real(.2), real(.2), 0});
  for (int i = 0; i < 30; ++i) {
    world.step();
    for (const ContactInfo& contact : world.contacts()) EXPECT_LT(length(contact.point), 40) << i;
  }
}

// Contacts of bodies between joints push only, and joints stay closed, through an impact.
TEST(DirectIsland, HoldsJointsThroughAnImpact) {
  World world(falling());
  add_floor(world, frictionless());
  const BodyId a = world.create_body(at(0, 2, 0, 0, 1), Shape::box({real(.5), real(.1)}), frictionless());
  const BodyId b = world.create_body(at(1, 2), Shape::box({real(.5), real(.1)}), frictionless());
  world.create_joint(RevoluteJoint{.a = a, .b = b, .anchor = {real(.5), 2}});
  for (int i = 0; i < 120; ++i) {
    world.step();
    const auto end = [&](BodyId id, double side) {
      return world.body(id).position() + Rotation(world.body(id).angle()) * Vec2{real(side), 0};
    };
    ASSERT_LT(length(end(a, .5) - end(b, -.5)), 1e-9 + 2 * rounded_gap) << i;
    for (const ContactInfo& contact : world.contacts()) ASSERT_GE(contact.normal_impulse, 0) << i;
  }
}

/// Boxes that fly at each other and spin, without weight: a different heap for each seed.
std::vector<BodyId> throw_together(World& world, unsigned seed, int count, double spin) {
  RandomShapes random(seed);
  std::vector<BodyId> boxes;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.28 * i / count;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const auto drawn = [&](double most) { return static_cast<double>(random.number(real(-most), real(most))); };
    boxes.push_back(world.create_body(at(x, y, -3 * x, -3 * y, drawn(spin), drawn(3)),
                                      Shape::box({real(.15), random.number(real(.1), real(.3))}),
                                      {1, real(.5), real(.3), real(.2)}));
  }
  return boxes;
}

/// m, the deepest overlap of any two.
double deepest(World& world, const std::vector<BodyId>& boxes) {
  double deepest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Body a = world.body(boxes[i]);
      const Body b = world.body(boxes[j]);
      const Manifold m = collide(a.parts()[0].shape, {a.position(), a.rotation()}, b.parts()[0].shape,
                                 {b.position(), b.rotation()}, 0);
      for (int k = 0; k < m.count; ++k) {
        deepest = std::max(deepest, -static_cast<double>(m.points[static_cast<std::size_t>(k)].separation));
      }
    }
  }
  return deepest;
}

// A corner that comes round within an interval, and an impact sooner than loads let expect, end it.
TEST(DirectIsland, LetsNoCornerComeRoundUnseen) {
  double most = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Settings settings;
    settings.gravity = {};
    World world(settings);
    const std::vector<BodyId> boxes = throw_together(world, seed, 4, 40);
    for (int step = 0; step < 40; ++step) {
      world.step();
      most = std::max(most, deepest(world, boxes));
    }
  }
  EXPECT_LT(most, 2e-4);
}

// A disc throws a triangle, whose corner is in that of wall and floor, against the wall. Its contact with a wall that
// goes on in a floor is not sought anew, as only the search removes ghosts, and its second corner was looked for only
// as far as it moved before the blow: it went 9 cm into the wall.
TEST(DirectIsland, LaysATriangleAgainstAWallThatMeetsTheFloor) {
  double most = 0;
  for (int i = 0; i < 60; ++i) {
    Settings settings;
    settings.gravity = {};
    World world(settings);
    const auto fix = [&world](BodyDef def, double x, double y) {
      def.type = BodyType::fixed;
      return world.create_body(def, Shape::box({real(x), real(y)}), frictionless());
    };
    const BodyId floor = fix(at(0, -.5), 5, .5);
    const BodyId wall = fix(at(-.5, 2), .5, 2.5);
    const double away = .01 + .005 * (i % 20);
    const double centre = (.3 + away) / 3;
    const std::array<Vec2, 3> corners{vec(-centre, -centre), vec(.3 - centre, away - centre),
                                      vec(away - centre, .3 - centre)};
    const BodyId triangle =
        world.create_body(at(centre + .0002, centre + .0002), Shape::polygon(corners), frictionless());
    world.create_body(at(.25, .27, -4 - 3. * (i / 20)), Shape::circle(real(.05)), {20, 0, 0, 0});
    for (int step = 0; step < 6; ++step) {
      world.step();
      most = std::max({most, deepest(world, {floor, triangle}), deepest(world, {wall, triangle})});
    }
  }
  EXPECT_LT(most, 2e-4);
}

/// Boxes of several masses that fall and slide onto each other and the ground, inelastic, with friction.
std::vector<BodyDef> colliding() {
  return {at(0, .5, 1), at(.95, .55, -.5, 0, 2, .2), at(.4, 1.7, 0, -3, 1, .4), at(-.9, .6, 2, -1, 0, .1)};
}

/// Where they are after a quarter of a second, still in motion, in the order of colliding(), when they are listed in
/// another one.
std::vector<Vec2> places(const std::vector<std::size_t>& order) {
  World world(falling());
  add_floor(world);
  const std::vector<BodyDef> defs = colliding();
  std::vector<BodyId> ids(defs.size());
  for (const std::size_t i : order) {
    Material material;
    material.density = real(1 + 3.0 * static_cast<double>(i));
    ids[i] = world.create_body(defs[i], Shape::box({real(.4), real(.3)}), material);
  }
  run(world, 15);
  std::vector<Vec2> found;
  found.reserve(ids.size());
  for (const BodyId id : ids) found.push_back(world.body(id).position());
  return found;
}

// A capsule lands on one end and slides on by most of its length in each sub-step: the end goes on to bear it, on
// whichever body points were remembered.
TEST(DirectIsland, FollowsThePointThatSlides) {
  for (const double speed : {0., 1.5, -1.5, 2.}) {
    std::vector<Body> capsules;
    std::vector<World> worlds(2, World(falling()));
    const auto add_capsule = [&](World& world) {
      capsules.push_back(world.body(world.create_body(at(.17, .011, speed, 0, 0, -.16),
                                                      Shape::capsule({real(-.0044), 0}, {real(.0044), 0}, real(.01)),
                                                      frictionless())));
    };
    add_floor(worlds[0], frictionless());
    add_capsule(worlds[0]);
    add_capsule(worlds[1]);
    add_floor(worlds[1], frictionless());
    for (World& world : worlds) world.step();
    // The end that landed stays on the floor, as closely as gaps are solved for.
    const double solved_gap = sizeof(Real) == 8 ? 1e-12 : 1e-6;
    for (const Body& capsule : capsules) {
      EXPECT_NEAR(static_cast<double>(capsule.position().y) + .0044 * std::sin(static_cast<double>(capsule.angle())),
                  .01, solved_gap)
          << speed;
    }
    EXPECT_NEAR(capsules[0].angular_velocity(), capsules[1].angular_velocity(), 1e6 * static_cast<double>(round_off));
  }
}

// The plane of a face of a body that turns sweeps over others a metre away. What may be struck by the rod has contacts
// that far.
TEST(DirectIsland, LetsNoPlaneOfAFacePushWhatIsFarFromIt) {
  Settings settings;
  settings.gravity = {};
  World world(settings);
  world.create_body(at(-.29, .59, 0, -1.7, 7.9, 2.5), Shape::capsule({real(-.9), 0}, {real(.9), 0}, real(.016)),
                    frictionless(1));
  const BodyId box = world.create_body(at(-.91, .13), Shape::box({real(.0415), real(.0415)}), frictionless());
  const std::vector<Vec2> corners{{real(.028), real(-.014)}, {real(.0077), real(.031)}, {real(-.03), real(.011)}};
  const BodyId spinning = world.create_body(at(.24, .069, 0, 0, -121, -3.6), Shape::polygon(corners), frictionless());
  world.step();
  EXPECT_EQ(world.body(box).velocity(), Vec2{});
  EXPECT_EQ(world.body(box).angular_velocity(), 0);
  EXPECT_EQ(world.body(spinning).angular_velocity(), -121);
}

// A disc meets the end of a capsule. Far away, places are rounded: by that, the point found was beside the end, and its
// side was taken for what the disc touches.
TEST(DirectIsland, MovesAlikeFarFromTheOrigin) {
  std::vector<Body> capsules;
  const Vec2 far{real(942.8644331), real(-586.104917876)};
  std::vector<World> worlds(2);
  for (const bool away : {false, true}) {
    World& world = worlds[away ? 1 : 0];
    world.set_gravity({});
    BodyDef disc = at(.72, .65, 0, -5.7);
    BodyDef capsule = at(.54071, .17438, 1.8664, 0, 21.819, 3.4509);
    if (away) disc.position += far;
    if (away) capsule.position += far;
    world.create_body(disc, Shape::circle(real(.31)), frictionless());
    const Shape shape = Shape::capsule({real(-.04509), 0}, {real(.04509), 0}, real(.10521));
    capsules.push_back(world.body(world.create_body(capsule, shape, frictionless())));
    world.step();
  }
  EXPECT_NEAR(capsules[0].angular_velocity(), capsules[1].angular_velocity(),
              1e6 * static_cast<double>(round_off) * 1e3);
}

// An angle between two of twelve boxes moves the last by up to 12 m times as much: what is rounding of a place is none
// of an angle. In single precision there are 17, too stiff to be solved with the compliance of contacts (.14 mm).
TEST(DirectIsland, HoldsABeamOfWeldedBoxesStill) {
  World world(falling());
  BodyDef wall = at(0, 0);
  wall.type = BodyType::fixed;
  BodyId last = world.create_body(wall, Shape::circle(real(.01)));
  constexpr int count = sizeof(Real) == 8 ? 12 : 17;
  for (int i = 0; i < count; ++i) {
    const BodyId next = world.create_body(at(i + .5, 0), Shape::box({real(.5), real(.2)}));
    world.create_joint(WeldJoint{last, next, {real(i), 0}});
    last = next;
  }
  // Each joint may be off by 4 epsilon of the farthest coordinate.
  const double most = count * 4 * 2 * static_cast<double>(round_off) * count;
  for (int step = 0; step < 120; ++step) {
    world.step();
    ASSERT_NEAR(static_cast<double>(world.body(last).position().y), 0, most) << step;
  }
}

TEST(DirectIsland, MovesAPileAlikeInWhateverOrderItIsListed) {
  const std::vector<Vec2> first = places({0, 1, 2, 3});
  std::vector<std::size_t> order{0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end())) {
    const std::vector<Vec2> then = places(order);
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_NEAR(length(then[i] - first[i]), 0, sizeof(Real) == sizeof(double) ? 1e-10 : 1e-4) << "box " << i;
    }
  }
}

// What friction and contacts take is gone: no blow adds energy.
TEST(DirectIsland, AddsNoEnergyInABlow) {
  World world(falling());
  add_floor(world);
  std::vector<BodyId> boxes;
  for (const BodyDef& def : colliding()) {
    boxes.push_back(world.create_body(def, Shape::box({real(.4), real(.3)})));
  }
  const auto energy = [&] {
    double sum = 0;
    for (const BodyId id : boxes) {
      const Body body = world.body(id);
      sum += kinetic(body) + 10 * static_cast<double>(body.mass().mass) * static_cast<double>(body.position().y);
    }
    return sum;
  };
  const double first = energy();
  double last = first;
  for (int step = 0; step < 60; ++step) {
    world.step();
    EXPECT_LT(energy(), last + 1e-4 * first) << "step " << step;
    last = energy();
  }
  EXPECT_LT(last, .5 * first);
}

// A disc that slides off a table faster than its edge could turn it flies from there on: y = -g t^2/2 since then,
// wherever in a sub-step that is. By sub-steps it was borne too long or too short, by up to .02 m/s.
TEST(DirectIsland, LetsADiscGoWhereItPassesAnEdge) {
  constexpr double speed = 2;
  for (const double before : {.1, .117, .131, .159}) {
    World world{Settings{}};
    BodyDef table;
    table.type = BodyType::fixed;
    world.create_body(table, Shape::box(vec(1, .5)), material(0));
    const BodyId disc = world.create_body(at(1 - before, .7, speed), Shape::circle(real(.2)), material(0));
    run(world, 18);
    const double flown = .3 - before / speed;
    EXPECT_NEAR(static_cast<double>(world.body(disc).position().y), .7 - g * flown * flown / 2, bound(1e-12, 2e-6));
    EXPECT_NEAR(static_cast<double>(world.body(disc).velocity().x), speed, bound(1e-12, 1e-6));
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::direct_island_test
