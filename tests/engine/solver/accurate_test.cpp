// The accuracy of the default method at 60 Hz with 4 sub-steps, against closed forms, over several random starts; float
// is limited by its 24 bits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::accurate_test {
namespace {

TEST(Accurate, FallsFreelyAsGalileoSays) {
  World world(accurate());
  const BodyId id = world.create_body(at(0, 100, 1, 2, 3), Shape::box(vec(.5, .5)));
  run_for(world, 1);
  EXPECT_NEAR(world.body(id).position().y, 100 + 2 - g / 2, bound(1e-9, 1e-4));
  EXPECT_NEAR(world.body(id).position().x, 1, bound(1e-9, 1e-4));
  EXPECT_NEAR(world.body(id).angle(), 3, bound(1e-9, 1e-5));
}

// e^(-c t), to second order: half the step, a quarter of the error.
TEST(Accurate, DampsToSecondOrder) {
  const auto error = [](double dt) {
    Settings settings = accurate();
    settings.dt = real(dt);
    World world(settings);
    BodyDef def = at(0, 0, 4, 0, 3);
    def.gravity_scale = 0;
    def.linear_damping = real(.8);
    def.angular_damping = real(1.5);
    const BodyId id = world.create_body(def, Shape::box(vec(.5, .5)));
    run(world, static_cast<int>(std::lround(1 / dt)));
    const Body body = world.body(id);
    return std::hypot(static_cast<double>(body.velocity().x) - 4 * std::exp(-.8),
                      static_cast<double>(body.angular_velocity()) - 3 * std::exp(-1.5));
  };
  EXPECT_LT(error(1.0 / 60), bound(1e-5, 2e-5));
  if (sizeof(Real) == sizeof(double)) {
    EXPECT_NEAR(error(1.0 / 30) / error(1.0 / 60), 4, .1);
  }
}

// x'' = -w^2 x - 2 g x': half the step, a quarter of the error.
TEST(Accurate, DampsASpringToSecondOrder) {
  constexpr double g = 3;
  constexpr double w = 5;
  const auto error = [&](double dt) {
    Settings settings = accurate();
    settings.dt = real(dt);
    settings.gravity = {};
    World world(settings);
    const BodyId id = world.create_body(at(2, 0), Shape::circle(real(.25)));
    const Real mass = world.body(id).mass().mass;
    world.add_force(Spring{.a = {},
                           .b = id,
                           .anchor_a = {},
                           .anchor_b = {},
                           .stiffness = real(w * w) * mass,
                           .length = 1,
                           .damping = real(2 * g) * mass});
    run(world, static_cast<int>(std::lround(.5 / dt)));
    const double swing = std::sqrt(w * w - g * g);
    const double x = std::exp(-g * .5) * (std::cos(swing * .5) + g / swing * std::sin(swing * .5));
    return std::abs(static_cast<double>(world.body(id).position().x) - 1 - x);
  };
  EXPECT_LT(error(1.0 / 60), 1e-4);
  if (sizeof(Real) == sizeof(double)) {
    EXPECT_NEAR(error(1.0 / 30) / error(1.0 / 60), 4, .3);
  }
}

TEST(Accurate, StopsUnderAnyDampingAndNeverTurnsBack) {
  World world(accurate());
  BodyDef def = at(0, 0, 100, 0);
  def.linear_damping = 10000;
  const BodyId id = world.create_body(def, Shape::circle(1));
  for (int i = 0; i < 10; ++i) {
    world.step();
    EXPECT_GE(world.body(id).position().x, -bound(1e-15, 1e-7)) << "but for the rounding of a step at 100 m/s";
    EXPECT_LE(std::abs(world.body(id).velocity().x), 1);
  }
  EXPECT_NEAR(static_cast<double>(world.body(id).velocity().y) * 10000 / -g, 1, bound(1e-9, 1e-3));
}

/// m/s after 1 s, of a box on two corners that moves at `speed` and is pulled by `pull` times its weight.
double pulled(const Material& m, double pull, double speed = 0) {
  Settings settings = accurate();
  settings.gravity = vec(pull * g, -g);
  World world(settings);
  ground(world, m);
  const BodyId box = world.create_body(at(0, .25, speed), Shape::box(vec(.5, .25)), m);
  run_for(world, 1);
  return static_cast<double>(world.body(box).velocity().x);
}

// Each corner alone would break away: what one cannot bear is left to the other.
TEST(Accurate, HoldsABoxUpToItsStaticFrictionAndThenSlidesWithTheDynamicOne) {
  for (const double dynamic : {0.0, .3, .55}) {
    const Material m{1, real(.6), real(dynamic), 0};
    EXPECT_NEAR(pulled(m, .599), 0, bound(1e-9, 1e-4)) << dynamic;
    EXPECT_NEAR(pulled(m, .601) / ((.601 - dynamic) * g), 1, bound(1e-4, 1e-3)) << dynamic;
  }
}

TEST(Accurate, GoesOnSlidingUnderAPullThatStaticFrictionWouldBear) {
  EXPECT_NEAR(pulled({1, real(.6), real(.3), 0}, .4, .5), .5 + .1 * g, bound(1e-4, 1e-3));
}

TEST(Accurate, SlidesDownASlopeWithCoulombsAcceleration) {
  for (const double degrees : {15.0, 20.0, 35.0}) {
    const double a = degrees * static_cast<double>(pi) / 180;
    const double mu = 0.2;
    World world(accurate());
    ground(world, material(0, mu), a);
    const BodyId id =
        world.create_body(tilted(-.5 * std::sin(a), .5 * std::cos(a), a), Shape::box(vec(.5, .5)), material(0, mu));
    const Vec2 start = world.body(id).position();
    run_for(world, 2);
    const double down = static_cast<double>(length(world.body(id).position() - start));
    const double expected = (g * (std::sin(a) - mu * std::cos(a))) * 2 * 2 / 2;
    EXPECT_NEAR(down / expected, 1, 1e-4) << degrees << " degrees";
  }
}

TEST(Accurate, RollsADiscDownWithTwoThirdsOfTheSlope) {
  for (const double degrees : {10.0, 20.0, 30.0}) {
    const double a = degrees * static_cast<double>(pi) / 180;
    World world(accurate());
    ground(world, material(0, 1), a);
    const BodyId id =
        world.create_body(at(-.5 * std::sin(a), .5 * std::cos(a)), Shape::circle(real(.5)), material(0, 1));
    const Vec2 start = world.body(id).position();
    run_for(world, 2);
    const double down = static_cast<double>(length(world.body(id).position() - start));
    EXPECT_NEAR(down / (2.0 / 3 * g * std::sin(a) * 2), 1, 1e-4) << degrees << " degrees";
  }
}

TEST(Accurate, StopsASlidingBoxWhereFrictionHasEatenItsEnergy) {
  for (const double v : {2.0, 3.3, 5.0}) {
    const double mu = 0.3;
    World world(accurate());
    ground(world, material(0, mu));
    const BodyId id = world.create_body(at(0, .25, v), Shape::box(vec(.5, .25)), material(0, mu));
    run_for(world, 3);
    EXPECT_NEAR(world.body(id).position().x / (v * v / (2 * mu * g)), 1, 1e-4) << v << " m/s";
    EXPECT_NEAR(world.body(id).velocity().x, 0, bound(1e-9, 1e-5));
  }
}

TEST(Accurate, SticksBelowTheFrictionAngleAndCreepsLessThanATenthOfAMillimetre) {
  const double mu = 0.5;
  const double a = std::atan(mu) - 0.02;
  World world(accurate());
  ground(world, material(0, mu), a);
  const BodyId id =
      world.create_body(tilted(-.5 * std::sin(a), .5 * std::cos(a), a), Shape::box(vec(.5, .5)), material(0, mu));
  const Vec2 start = world.body(id).position();
  run_for(world, 2);
  const Vec2 soon = world.body(id).position();
  EXPECT_LT(length(soon - start), 1e-4);
  run_for(world, 8);
  EXPECT_LT(length(world.body(id).position() - soon), 1e-5);
}

TEST(Accurate, TurnsSlippingIntoRolling) {
  const double mu = 0.25;
  const double v0 = 4;
  World world(accurate());
  ground(world, material(0, mu));
  const BodyId id = world.create_body(at(0, .5, v0), Shape::circle(real(.5)), material(0, mu));
  run_for(world, 1);
  EXPECT_NEAR(world.body(id).velocity().x, 2 * v0 / 3, bound(1e-6, 1e-4));
  EXPECT_NEAR(world.body(id).angular_velocity(), -2 * v0 / 3 / .5, bound(1e-6, 1e-4 * 2 * v0 / 3 / .5));
}

/// Apexes of a bouncing disc, by the parabola through three samples.
std::vector<double> apexes(double e, double height, double seconds, double* energy_change) {
  World world(accurate());
  ground(world, material(e));
  const BodyId id = world.create_body(at(0, .5 + height), Shape::circle(real(.5)), material(e));
  const double before = energy(world);
  std::vector<double> found;
  double y0 = height;
  double y1 = height;
  const int steps = static_cast<int>(std::lround(seconds * 60));
  for (int i = 0; i < steps; ++i) {
    world.step();
    const double y = static_cast<double>(world.body(id).position().y) - .5;
    const double curve = y0 - 2 * y1 + y;
    // Only where all three samples are of one flight: its second difference is -g dt^2.
    if (i > 1 && y1 >= y0 && y1 > y && std::abs(curve + g / 3600) < 1e-5) {
      found.push_back(y1 - (y - y0) * (y - y0) / (8 * curve));
    }
    y0 = y1;
    y1 = y;
  }
  *energy_change = (energy(world) - before) / (before - g * static_cast<double>(world.body(id).mass().mass) * .5);
  return found;
}

TEST(Accurate, BouncesToTheSquareOfRestitution) {
  std::mt19937 random(1);
  for (const double e : {.5, .8, 1.0}) {
    for (int start = 0; start < 4; ++start) {
      const double h = seeded(random, 1, 3);
      double change = 0;
      const std::vector<double> found = apexes(e, h, 3, &change);
      ASSERT_GE(found.size(), 2U);
      EXPECT_NEAR(found[0] / (e * e * h), 1, bound(1e-6, 1e-4)) << "e " << e << " h " << h;
      EXPECT_NEAR(found[1] / (e * e * e * e * h), 1, bound(1e-6, 1e-4)) << "e " << e << " h " << h;
    }
  }
}

TEST(Accurate, KeepsTheEnergyOfAPerfectBounceForTenSeconds) {
  std::mt19937 random(2);
  for (int start = 0; start < 4; ++start) {
    double change = 0;
    apexes(1, seeded(random, 1, 3), 10, &change);
    EXPECT_NEAR(change, 0, bound(1e-6, 1e-4));
  }
}

TEST(Accurate, ReflectsADiscFromAWallWithFrictionAndSpin) {
  const double mu = 0.3;
  const double e = 0.6;
  std::mt19937 random(3);
  for (int start = 0; start < 4; ++start) {
    Settings settings = accurate();
    settings.gravity = {};
    World world(settings);
    ground(world, material(e, mu));
    const double vx = seeded(random, -4, 4);
    const double vy = seeded(random, -6, -2);
    const double w = seeded(random, -8, 8);
    const BodyId id = world.create_body(at(0, 2, vx, vy, w), Shape::circle(real(.5)), material(e, mu));
    run_for(world, 2);
    // Jt stops the contact point's slip (effective mass m/3) or is mu Jn.
    const double jn = -(1 + e) * vy;
    const double slip = vx + w * .5;
    const double jt = std::clamp(-slip / 3, -mu * jn, mu * jn);
    EXPECT_NEAR(world.body(id).velocity().y, -e * vy, bound(1e-9, 1e-5));
    EXPECT_NEAR(world.body(id).velocity().x, vx + jt, bound(1e-6, 1e-4));
    EXPECT_NEAR(world.body(id).angular_velocity(), w + jt * .5 / (.5 * .25), bound(1e-6, 1e-4));
  }
}

TEST(Accurate, ScattersDiscsObliquelyUpToAThousandfoldMass) {
  for (const double ratio : {1.0, 10.0, 1000.0}) {
    const double e = 1;
    Settings settings = accurate();
    settings.gravity = {};
    World world(settings);
    Material heavy = material(e);
    heavy.density = real(ratio);
    const BodyId a = world.create_body(at(-2, 0, 3, 0), Shape::circle(real(.5)), material(e));
    const BodyId b = world.create_body(at(1, .4, -1, .1), Shape::circle(real(.5)), heavy);
    run_for(world, 2);
    // In the frame of the centres: at contact the distance is 1, so the offset along the path gives the normal.
    const double rx = 3.0;
    const double ry = .4;
    const double ux = -4.0;
    const double uy = .1;  // of b relative to a
    const double uu = ux * ux + uy * uy;
    const double ru = rx * ux + ry * uy;
    const double t = (-ru - std::sqrt(ru * ru - uu * (rx * rx + ry * ry - 1))) / uu;
    const double nx = rx + ux * t;
    const double ny = ry + uy * t;
    const double vn = ux * nx + uy * ny;
    const double j = -(1 + e) * vn / (1 + 1 / ratio);
    EXPECT_NEAR(world.body(a).velocity().x, 3 - j * nx, bound(1e-9, 1e-4));
    EXPECT_NEAR(world.body(a).velocity().y, -j * ny, bound(1e-9, 1e-4));
    EXPECT_NEAR(world.body(b).velocity().x, -1 + j * nx / ratio, bound(1e-9, 1e-4));
    EXPECT_NEAR(world.body(b).position().x, 1 - 2 + j * nx / ratio * (2 - t), bound(1e-6, 1e-4));
  }
}

TEST(Accurate, LandsABoxOnItsCornerByTheImpulseLaw) {
  std::mt19937 random(4);
  for (int start = 0; start < 4; ++start) {
    const double e = seeded(random, .3, 1);
    const double angle = seeded(random, .3, .7);
    const double w = seeded(random, 0, .5);
    World world(accurate());
    ground(world, material(e));
    const double drop = 1;
    const BodyId id = world.create_body(at(0, 2, 0, 0, w, angle), Shape::box(vec(.5, .5)), material(e));
    // The corner that is lowest at the impact, found by bisection on its exact height.
    const auto height = [&](double t) {
      const double phi = angle + w * t;
      return 2 - g * t * t / 2 - .5 * (std::sin(phi) + std::cos(phi));
    };
    double low = 0;
    double high = 1;
    for (int i = 0; i < 200; ++i) (height((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    const double t = low;
    const double phi = angle + w * t;
    // Corner (-.5, -.5) turned by phi; its arm across the normal is rx.
    const double rx = -.5 * std::cos(phi) + .5 * std::sin(phi);
    const double vn = -g * t + w * rx;
    const double inertia = 1.0 / 6;
    const double j = -(1 + e) * vn / (1 + rx * rx / inertia);
    const int steps = static_cast<int>(std::ceil(t * 60));
    for (int i = 0; i < steps; ++i) world.step();
    const double after = steps / 60.0;
    EXPECT_NEAR(world.body(id).angular_velocity(), w + rx * j / inertia, bound(1e-6, 1e-4)) << drop;
    EXPECT_NEAR(world.body(id).velocity().y, -g * after + j, bound(1e-6, 1e-4));
  }
}

TEST(Accurate, PassesSpeedThroughACradleOfFive) {
  for (const double gap : {0.0, 0.01}) {
    Settings settings = accurate();
    settings.gravity = {};
    World world(settings);
    std::vector<BodyId> balls;
    for (int i = 0; i < 5; ++i) {
      balls.push_back(world.create_body(at(i * (1 + gap) + (i == 0 ? -1 : 0), 0, i == 0 ? 2 : 0),
                                        Shape::circle(real(.5)), material(1)));
    }
    run_for(world, 2);
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(world.body(balls[static_cast<std::size_t>(i)]).velocity().x, i == 4 ? 2 : 0, bound(1e-6, 1e-4));
    }
  }
}

/// Impacts of a light block between a wall and a heavy one that comes at it (Galperin 2003), by changes of velocity.
int galperin(double ratio, double seconds) {
  Settings settings = accurate();
  settings.gravity = {};
  World world(settings);
  BodyDef wall;
  wall.type = BodyType::fixed;
  world.create_body(wall, Shape::half_space({1, 0}, 0), material(1));
  Material heavy = material(1);
  heavy.density = real(ratio);
  const BodyId light = world.create_body(at(2, 0), Shape::circle(real(.5)), material(1));
  const BodyId big = world.create_body(at(4, 0, -1), Shape::circle(real(.5)), heavy);
  // Each impact with the big block changes its momentum by 2 m |u|; in the plane (sqrt(M) V, sqrt(m) v) every pair of
  // impacts turns the state by 2 theta with tan(theta) = sqrt(m/M), so the final angle tells how many there were.
  run_for(world, seconds);
  const double theta = std::atan(1 / std::sqrt(ratio));
  const double big_v = static_cast<double>(world.body(big).velocity().x);
  const double light_v = static_cast<double>(world.body(light).velocity().x);
  EXPECT_NEAR(std::sqrt(big_v * big_v + light_v * light_v / ratio), 1, bound(1e-9, 1e-4));
  // State starts at angle pi; after n pairs it stands at pi - 2 n theta.
  const double angle = std::atan2(light_v / std::sqrt(ratio), big_v);
  const double pairs = (static_cast<double>(pi) - angle) / (2 * theta);
  EXPECT_LT(std::abs(light_v), big_v + 1e-3);
  // A last impact with the wall mirrors the light block's velocity; either parity is told by the count of half turns.
  return static_cast<int>(std::lround(2 * pairs));
}

TEST(Accurate, CountsTheDigitsOfPiInCollisions) {
  EXPECT_EQ(galperin(100, 12), 31);
  EXPECT_EQ(galperin(10000, 12), 314);
}

TEST(Accurate, RollsExactlyWhileItsContactIsFoundAgain) {
  // Slow at first, so that points are kept from step to step while the disc sinks into its springs.
  World world(accurate());
  ground(world, material(0, .5), -.2);
  const BodyId id =
      world.create_body(at(.5 * std::sin(.2), .5 * std::cos(.2)), Shape::circle(real(.5)), material(0, .5));
  run_for(world, 2);
  const Body body = world.body(id);
  EXPECT_NEAR(length(body.velocity()) / (2.0 / 3 * g * std::sin(.2) * 2), 1, bound(1e-12, 1e-5));
  EXPECT_NEAR(-body.angular_velocity() * real(.5) / length(body.velocity()), 1, bound(1e-12, 1e-5));
}

// A step without contacts and joints takes a shorter code path.
TEST(Accurate, FliesWithTheSameBitsNextToBodiesThatTouch) {
  const auto flight = [](bool others) {
    World world(accurate());
    const BodyId thrown = world.create_body(at(1.5, 100, 3.1, 7.3, 2.7, 0.3), Shape::box(vec(0.5, 0.25)), material(0));
    if (others) {
      BodyDef floor;
      floor.type = BodyType::fixed;
      world.create_body(floor, Shape::half_space(vec(0, 1), 0), material(0));
      world.create_body(at(0, 1), Shape::circle(real(1)), material(0));
    }
    for (int i = 0; i < 200; ++i) world.step();
    const Body body = world.body(thrown);
    return std::vector<Real>{body.position().x, body.position().y, body.angle(),
                             body.velocity().x, body.velocity().y, body.angular_velocity()};
  };
  EXPECT_EQ(flight(false), flight(true));
}

/// The state of bodies of several kinds after two seconds, of which some come to rest and one is pushed.
std::vector<Vec2> ends(bool disturbed) {
  World world(accurate());
  BodyDef floor;
  floor.type = BodyType::fixed;
  world.create_body(floor, Shape::box({20, 1}, {0, -1}), material(0, .6));
  std::vector<BodyId> bodies;
  for (int i = 0; i < 3; ++i) {
    bodies.push_back(world.create_body(at(.01 * i, .5 + i), Shape::box({real(.5), real(.5)}), material(0, .6)));
  }
  bodies.push_back(world.create_body(at(3, .5), Shape::circle(real(.5)), material(0, .6)));
  bodies.push_back(world.create_body(tilted(5, .6, .1), Shape::box({1, real(.5)}), material(0, .3)));
  for (int step = 0; step < 120; ++step) {
    if (disturbed) world.destroy_body(world.create_body(at(0, 100), Shape::circle(1), material(0)));
    if (step == 60) world.body(bodies.back()).set_velocity({1, 0}, 0);
    if (step == 90) world.set_dt(real(1. / 90));
    world.step();
  }
  std::vector<Vec2> where;
  for (const BodyId id : bodies) {
    where.push_back(world.body(id).position());
    where.push_back(world.body(id).velocity());
  }
  return where;
}

// Destroying a body discards what is kept of the contacts of the last step.
TEST(Accurate, KeepingContactsBetweenStepsChangesNoBit) { EXPECT_EQ(ends(false), ends(true)); }

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::accurate_test
