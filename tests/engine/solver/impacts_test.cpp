#include "solver/impacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "../support.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::impacts_test {
namespace {

// The corner it stands on carries it throughout, although the other one is about to bounce.
TEST(Impacts, HoldABoxThatTipsOntoItsFaceAtTheCornerItStandsOn) {
  constexpr double half = 0.15;
  constexpr double turn = 2;  // rad/s
  constexpr double lean = 0.6;
  World world{Settings{}};
  const Material bouncing{1, real(.5), real(.5), real(.1)};
  add_floor(world, bouncing);
  // Turns about its lower right corner, which touches the floor.
  const double across = half * (std::cos(lean) - std::sin(lean));
  const double up = half * (std::cos(lean) + std::sin(lean));
  BodyDef def = at(0, up, turn * -up, turn * -across);
  def.angle = real(-lean);
  def.angular_velocity = real(turn);
  const BodyId box = world.create_body(def, Shape::box({real(half), real(half)}), bouncing);
  const auto lowest = [&] {
    const Body body = world.body(box);
    Real low = 1;
    for (const double x : {-half, half})
      low = std::min(low, (body.position() + body.rotation() * Vec2{real(x), real(-half)}).y);
    return static_cast<double>(low);
  };
  double deepest = 0;
  for (int step = 0; step < 12; ++step) {
    world.step();
    deepest = std::min(deepest, lowest());
  }
  EXPECT_GT(deepest, -1e-4);
}

// While it slips, the dynamic coefficient acts: Jt = mu_d (1 + e) v, although the static one could stop it.
TEST(Impacts, SlipWithTheDynamicCoefficient) {
  constexpr double e = 0.6;
  Settings weightless;
  weightless.gravity = {};
  World world(weightless);
  const Material m{1, real(.8), real(.2), real(e)};
  add_floor(world, m);
  const BodyId ball = world.create_body(at(0, 1, 5, -2), Shape::circle(real(.5)), m);
  run(world, 60);
  EXPECT_NEAR(static_cast<double>(world.body(ball).velocity().x), 5 - .2 * (1 + e) * 2, 1e-5);
  EXPECT_NEAR(static_cast<double>(world.body(ball).angular_velocity() * real(.25)), -.2 * (1 + e) * 2, 1e-5);
}

// The disc keeps v' = (1 + 2 cos a)/3 v, cos a = 1 - h/r, and then 3/4 v'^2 + g y, whenever in a sub-step it meets the
// edge: until then the floor bears its weight, and from then on nothing but the edge. 2 % of the energy were lost when
// the solve of all contacts stopped it at some end of a sub-step.
TEST(Impacts, TurnADiscAboutTheEdgeOfAStepFromWhenItMeetsIt) {
  constexpr double radius = 0.5;
  constexpr double height = 0.1;
  constexpr double speed = 1.8;
  const Material rough{1, 2, 2, 0};
  Settings settings;
  settings.gravity = {0, -10};
  for (int phase = 0; phase < 12; ++phase) {
    World world(settings);
    add_floor(world, rough);
    BodyDef step = at(2, height / 2);
    step.type = BodyType::fixed;
    world.create_body(step, Shape::box({2, real(height / 2)}), rough);
    BodyDef def = at(-.4 - .0025 * phase, radius, speed, 0);
    def.angular_velocity = real(-speed / radius);
    const BodyId disc = world.create_body(def, Shape::circle(real(radius)), rough);
    run(world, 10);
    const auto v = static_cast<double>(length(world.body(disc).velocity()));
    const auto w = static_cast<double>(world.body(disc).angular_velocity());
    const double energy =
        .5 * v * v + .25 * radius * radius * w * w + 10 * (static_cast<double>(world.body(disc).position().y) - radius);
    const double kept = (1 + 2 * (1 - height / radius)) / 3 * speed;
    EXPECT_NEAR(energy, .75 * kept * kept, 6e-3) << phase;
  }
}

// A light block between a heavy one and a wall: 314 impacts for a mass ratio of 10^4 (Galperin 2003), nearly all within
// one sub-step. With 96 at most, the heavy block lost its energy.
TEST(Impacts, CountTheDigitsOfPiWithinASubStep) {
  Settings weightless;
  weightless.gravity = {};
  World world(weightless);
  const Material elastic{1, 0, 0, 1};
  BodyDef wall;
  wall.type = BodyType::fixed;
  world.create_body(wall, Shape::half_space({1, 0}, 0), elastic);
  const BodyId light = world.create_body(at(1, 0), Shape::box({real(.05), real(.05)}), elastic);
  Material dense = elastic;
  dense.density = 10000;
  const BodyId heavy = world.create_body(at(2, 0, -10), Shape::box({real(.05), real(.05)}), dense);
  run(world, 60);
  EXPECT_NEAR(static_cast<double>(world.body(heavy).velocity().x), 10, 0.01);
  EXPECT_LT(std::abs(static_cast<double>(world.body(light).velocity().x)), 10 * 100.0);
}

// The wave of a cradle passes gaps of a tenth of a metre within one step: no ball is missed by the one that is hit
// before it.
TEST(Impacts, PassOnThroughBallsThatAreFarApart) {
  Settings weightless;
  weightless.gravity = {};
  World world(weightless);
  const Material elastic{1, 0, 0, 1};
  std::vector<BodyId> balls(6);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const BodyDef def = at(1.07 * static_cast<double>(i), 0, i == 0 ? 30 : 0);
    balls[i] = world.create_body(def, Shape::circle(real(.5)), elastic);
  }
  run(world, 12);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(world.body(balls[i]).velocity().x), i == 5 ? 30 : 0, 1e-4) << i;
  }
}

// Two welded discs are one rigid body, whose impact has a closed form: K J = (-(1 + e) vn, -vt) at the point that hits,
// if friction stops the sliding. The joint passes the impact on, and friction acts on what comes back.
TEST(Impacts, StopTheSlidingOfWeldedDiscsAsThatOfOneBody) {
  constexpr double radius = 0.2;
  constexpr double e = 0.5;
  const Vec2 half{real(.4), real(.3)};  // from the centre to the upper disc
  const Vec2 start{real(.7), -2};       // m/s
  Settings weightless;
  weightless.gravity = {};
  World world(weightless);
  const Material rough{1, real(.9), real(.9), real(e)};
  add_floor(world, rough);
  const auto disc = [&](Vec2 from) {
    return world.create_body(at(static_cast<double>(from.x), 1 + static_cast<double>(from.y),
                                static_cast<double>(start.x), static_cast<double>(start.y)),
                             Shape::circle(real(radius)), rough);
  };
  const BodyId lower = disc({-half.x, -half.y});
  const BodyId upper = disc(half);
  world.create_joint(WeldJoint{lower, upper, {0, 1}});
  const double mass = 2 * static_cast<double>(world.body(lower).mass().mass);
  const double inertia = mass * radius * radius / 2 + mass * static_cast<double>(dot(half, half));
  const double x = -static_cast<double>(half.x);
  const double y = -static_cast<double>(half.y) - radius;  // from the centre to the point that hits
  const double knn = 1 / mass + x * x / inertia;
  const double ktt = 1 / mass + y * y / inertia;
  const double knt = -x * y / inertia;
  const double n = -(1 + e) * static_cast<double>(start.y);
  const double t = -static_cast<double>(start.x);
  const double along = (ktt * n - knt * t) / (knn * ktt - knt * knt);
  const double across = (knn * t - knt * n) / (knn * ktt - knt * knt);
  ASSERT_LT(std::abs(across), 0.9 * along);
  run(world, 16);  // hits after 15
  const Vec2 mean = (world.body(lower).velocity() + world.body(upper).velocity()) * real(.5);
  EXPECT_NEAR(static_cast<double>(mean.x), static_cast<double>(start.x) + across / mass, 3e-5);
  EXPECT_NEAR(static_cast<double>(mean.y), static_cast<double>(start.y) + along / mass, 3e-5);
  EXPECT_NEAR(static_cast<double>(world.body(lower).angular_velocity()), (x * along - y * across) / inertia, 3e-5);
}

// At e = 0 as at any other: the discs touch where they meet, whatever the sub-step, so the angular momentum about the
// origin stays and the impulse along the normal is the whole one.
TEST(Impacts, StopInelasticDiscsWhereTheyMeet) {
  Settings weightless;
  weightless.gravity = {};
  for (const double offset : {0.0, 0.35, 0.8}) {
    World world(weightless);
    const Material rough{1, real(.3), real(.3), 0};
    const BodyId left = world.create_body(at(-2, 0, 3, 0, 4), Shape::circle(real(.5)), rough);
    const BodyId right = world.create_body(at(2.03, offset, -4, 0, -1), Shape::circle(real(.5)), rough);
    const auto spin = [&] {
      const auto of = [&](BodyId id) {
        const Body body = world.body(id);
        const double mass = static_cast<double>(pi) / 4;
        const double across = static_cast<double>(body.position().x) * static_cast<double>(body.velocity().y) -
                              static_cast<double>(body.position().y) * static_cast<double>(body.velocity().x);
        return mass * across + mass / 8 * static_cast<double>(body.angular_velocity());
      };
      return of(left) + of(right);
    };
    const double before = spin();
    run(world, 60);
    EXPECT_NEAR(spin(), before, bound(1e-13, 1e-5)) << offset;
    const Vec2 apart = world.body(right).position() - world.body(left).position();
    const Vec2 closing = world.body(right).velocity() - world.body(left).velocity();
    EXPECT_GT(std::hypot(static_cast<double>(apart.x), static_cast<double>(apart.y)), 1 - bound(1e-9, 1e-5)) << offset;
    EXPECT_LT(static_cast<double>(std::abs(closing.x)), 7) << offset;
  }
}

double angular_momentum(const Body& body) {
  const MassData of = body.mass();
  return static_cast<double>(of.mass * cross(body.position(), body.velocity()) + of.inertia * body.angular_velocity());
}

// The surfaces slide past each other between the search for contacts and the impact; both bodies are struck in one
// place.
TEST(Impacts, KeepTheAngularMomentumOfTwoFreeBoxes) {
  Settings weightless;
  weightless.gravity = {};
  for (const double spin : {-6.0, 0.0, 6.0}) {
    for (const double e : {0.0, 0.5}) {
      World world(weightless);
      const Material rough{1, real(.5), real(.5), real(e)};
      const BodyId left = world.create_body(at(0, 0, 1, 0, spin), Shape::box(vec(.2, .5)), rough);
      const BodyId right = world.create_body(at(1.2, .4, -4, -.5, -2), Shape::box(vec(.3, .3)), rough);
      const auto momentum = [&] { return angular_momentum(world.body(left)) + angular_momentum(world.body(right)); };
      const double before = momentum();
      const Vec2 flew = world.body(right).velocity();
      run(world, 30);
      EXPECT_GT(static_cast<double>(length(world.body(right).velocity() - flew)), .5) << "no impact";
      EXPECT_NEAR(momentum(), before, e > 0 ? bound(1e-6, 1e-5) : 1e-3) << "spin " << spin << ", e " << e;
    }
  }
}

// A disc that flies past a corner at 54 m/s, 22 cm in a sub-step, hits neither the corner nor the plane of a face.
TEST(Impacts, LetADiscPassACornerWithoutTouchingIt) {
  Settings weightless;
  weightless.gravity = {};
  for (int place = 0; place < 20; ++place) {
    World world(weightless);
    const Material bouncing{1, real(.5), real(.5), real(.5)};
    const BodyId disc = world.create_body(at(.01 * place, 0, 54, 0), Shape::circle(real(.07)), bouncing);
    BodyDef def = at(3, .0701 + .1 * std::sqrt(2));
    def.angle = pi / 4;
    world.create_body(def, Shape::box(vec(.1, .1)), bouncing);
    run(world, 10);
    EXPECT_EQ(world.body(disc).velocity(), vec(54, 0)) << place;
  }
}

// cos a = 2/3 is where a disc leaves a smooth dome; until then, and after, its energy stays.
TEST(Impacts, GiveADiscOnADomeNoEnergy) {
  World world{Settings{}};
  const Material smooth{1, 0, 0, 0};
  BodyDef fixed;
  fixed.type = BodyType::fixed;
  world.create_body(fixed, Shape::circle(1), smooth);
  const BodyId disc = world.create_body(at(1.25 * std::sin(.1), 1.25 * std::cos(.1)), Shape::circle(real(.25)), smooth);
  const auto energy = [&] {
    const Body body = world.body(disc);
    return static_cast<double>(10 * body.position().y + dot(body.velocity(), body.velocity()) / 2);
  };
  const double before = energy();
  for (int step = 0; step < 60; ++step) {
    world.step();
    // (w h)^2 of it, for at most w^2 = 2 g (1 - 2/3) / 1.25 m; with the whole impulse turned 15 times that.
    EXPECT_LT(energy(), before * (1 + 5.4 / (240. * 240))) << step;
  }
}

// Mirrored, the block has its two points the other way round.
TEST(Impacts, RockABlockAsItsMirrorImage) {
  const auto rocking = [](double side) {
    World world{Settings{}};
    const Material rough{1, 1, 1, 0};
    add_floor(world, rough);
    BodyDef def = at(0, 1.0053);
    def.angle = real(-.033 * side);
    const BodyId block = world.create_body(def, Shape::box(vec(.1744, 1)), rough);
    run(world, 60);
    return std::pair{world.body(block).position().x * real(side), world.body(block).angle() * real(side)};
  };
  const auto right = rocking(1);
  const auto left = rocking(-1);
  EXPECT_NEAR(static_cast<double>(right.first), static_cast<double>(left.first), bound(1e-12, 1e-4));
  EXPECT_NEAR(static_cast<double>(right.second), static_cast<double>(left.second), bound(1e-12, 1e-4));
}

// A heavy disc drums a light box against the floor. A corner that rises while the other is struck is pushed back by
// what strikes that. Stopped instead, it gained 1.65 J of 218 J, and 24 of the 180 gained more than 1e-5.
// What a box gains that tips about its corner is of second order.
TEST(Impacts, PushCornersBackWithoutAGainOfEnergy) {
  for (const double restitution : {.8, .9, 1.}) {
    for (const double beside : {.05, .1, .15, .2, .25, .3}) {
      for (const double density : {5., 20., 60., 200., 1000.}) {
        for (const double tilt : {0., .02}) {
          World world{Settings{}};
          const Material elastic = material(restitution);
          ground(world, elastic);
          const double low = .3635 * (std::cos(tilt) + std::sin(tilt));
          world.create_body(tilted(0, low, tilt), Shape::box(vec(.3635, .3635)), elastic);
          Material heavy = elastic;
          heavy.density = real(density);
          world.create_body(at(beside, low + .3635 + .22), Shape::circle(real(.2)), heavy);
          const double before = energy(world);
          for (int step = 0; step < 60; ++step) {
            world.step();
            ASSERT_LE(energy(world), before * (1 + bound(1e-6, 1e-5)))
                << restitution << ' ' << beside << ' ' << density << ' ' << tilt << ' ' << step;
          }
        }
      }
    }
  }
}

// An elastic box that leans falls on its corner. What slides the way in which the corner is thrown turns round: with
// all of the restitution that creates energy. As soon as it would, 1 m/s of 2 was missing.
TEST(Impacts, OfACornerChangeLittleWithWhatSlidesALittle) {
  const auto after = [](double slide) {
    World world{Settings{}};
    const Material elastic = material(1, 1);
    ground(world, elastic);
    constexpr double lean = .3;
    BodyDef def = tilted(0, .5 * (std::cos(lean) + std::sin(lean)) + 1e-3, lean);
    def.velocity = vec(slide, -2);
    const BodyId box = world.create_body(def, Shape::box({real(.5), real(.5)}), elastic);
    world.step();
    return std::pair{world.body(box).velocity(), world.body(box).angular_velocity()};
  };
  const auto [v, w] = after(0);
  for (const double slide : {-.01, -1e-3, 1e-3, .01}) {
    const auto [there, turning] = after(slide);
    EXPECT_LT(static_cast<double>(length(there - v)), 4 * std::abs(slide)) << slide;
    EXPECT_LT(static_cast<double>(std::abs(turning - w)), 4 * std::abs(slide)) << slide;
  }
}

// Damping of 3/s slows a disc that bounces off the floor: before the impact v = -g/c (1 - exp(-c t)), after it
// v = (e u + g/c) exp(-c t) - g/c. With the damping of the speed before the impact it was off by 2.2 mm, in first
// order; of second order, (c h)^2/12 of the way of .7 m is 9e-6 m, before the impact and after.
TEST(Impacts, AreFollowedByTheDampingOfTheirRebound) {
  constexpr double c = 3;
  constexpr double e = .6;
  constexpr double fall = .7;  // m
  const auto fallen = [](double t) { return g / c * (t - (1 - std::exp(-c * t)) / c); };
  double low = 0;
  double high = 2;
  for (int round = 0; round < 60; ++round) (fallen((low + high) / 2) < fall ? low : high) = (low + high) / 2;
  const double up = e * g / c * (1 - std::exp(-c * low));

  World world{Settings{}};
  ground(world, material(e));
  BodyDef def = at(0, fall + .25);
  def.linear_damping = real(c);
  const BodyId disc = world.create_body(def, Shape::circle(real(.25)), material(e));
  run(world, 36);
  const double since = .6 - low;
  ASSERT_LT(low, .5);
  const double height = .25 + (up + g / c) / c * (1 - std::exp(-c * since)) - g / c * since;
  EXPECT_NEAR(static_cast<double>(world.body(disc).position().y), height, 2e-5);
}

// What falls along a wall is not pressed against it, and two that fall beside each other not together: however slowly
// they meet, they rebound. A threshold by gravity alone, of .1 m/s, made both inelastic.
TEST(Impacts, ReboundHoweverSlowlyWhereNothingPresses) {
  constexpr double e = .8;
  constexpr double slow = .04;  // m/s
  World world{Settings{}};
  BodyDef wall;
  wall.type = BodyType::fixed;
  world.create_body(wall, Shape::half_space({1, 0}, 0), material(e));
  const BodyId beside = world.create_body(at(.26, 50, -slow), Shape::circle(real(.25)), material(e));
  const BodyId left = world.create_body(at(3, 50, slow), Shape::circle(real(.25)), material(e));
  const BodyId right = world.create_body(at(3.51, 50), Shape::circle(real(.25)), material(e));
  run(world, 40);
  const auto across = [&](BodyId body) { return static_cast<double>(world.body(body).velocity().x); };
  EXPECT_NEAR(across(beside), e * slow, bound(1e-12, 1e-6));
  EXPECT_NEAR(across(left), (1 - e) / 2 * slow, bound(1e-12, 1e-6));
  EXPECT_NEAR(across(right), (1 + e) / 2 * slow, bound(1e-12, 1e-6));
}

// rad, of a block that rocks from corner to corner at small angles, after a second in steps of 1/n s.
double angle_of_rocking_block(int n) {
  Settings settings;
  settings.dt = real(1. / n);
  World world(settings);
  const Material brick = material(.3592, 1);
  ground(world, brick);
  const BodyId block = world.create_body(at(0, 1.0036, 0, 0, 0, -.02615456), Shape::box(vec(.1504, 1)), brick);
  run(world, n);
  return static_cast<double>(world.body(block).angle());
}

// A corner that strikes at a tenth of a metre in a second rebounds, too, and how long the block then stands on the
// other one decides all that follows: .006 rad when it did not.
TEST(Impacts, OfARockingBlockReboundAsSmallStepsDo) {
  EXPECT_NEAR(angle_of_rocking_block(60), angle_of_rocking_block(1920), bound(2e-5, 2e-4));
}

Material weighs(double density, double restitution) { return {real(density), 0, 0, real(restitution)}; }

// A plank on the floor with two rows of 13 small boxes, which begin at these places: more contacts than are solved as
// one system, so that what touches the plank is swept.
BodyId plank_with_boxes(World& world, double half_length, double density, std::array<double, 2> rows) {
  ground(world, weighs(1, 0));
  const BodyId plank = world.create_body(at(0, .1), Shape::box(vec(half_length, .1)), weighs(density, 0));
  for (const double first : rows) {
    for (int i = 0; i < 13; ++i) {
      world.create_body(at(first + .25 * i, .3), Shape::box(vec(.1, .1)), weighs(1, 0));
    }
  }
  return plank;
}

// A disc on a plank is struck by a heavier one, again and again as it rebounds between both, and the plank stops it.
// With 26 boxes on the plank the island is swept: an impact shifts the start of a path, and what stopped the disc after
// it, in the same sub-step, left it where that was, up to 1.4 mm deep in the plank.
TEST(Impacts, LeaveNoBodyWhereTheyShiftedItsPath) {
  for (int k = 0; k < 12; ++k) {
    World world{Settings{}};
    const BodyId plank = plank_with_boxes(world, 4, 5, {-3.9, .9});
    const BodyId disc = world.create_body(at(0, .4), Shape::circle(real(.2)), weighs(5, 1));
    world.create_body(at(.02, 1.4 + .03 * k, 0, -15), Shape::circle(real(.3)), weighs(20, 1));
    double deepest = 0;
    for (int step = 0; step < 60; ++step) {
      world.step();
      const Vec2 apart = world.body(disc).position() - world.body(plank).position();
      deepest = std::min(deepest, static_cast<double>(apart.y) - .3);
    }
    EXPECT_GT(deepest, -5e-5) << k;
  }
}

// A blow without a rebound goes through a row of discs which approach each other, but would not meet in this sub-step:
// each of them is held only when the one before it comes. 26 boxes on the same plank let the island be swept. Where
// only one of them was held so, others went 2 mm into each other.
TEST(Impacts, HoldWhateverABlowDrivesTogether) {
  for (int k = 0; k < 8; ++k) {
    World world{Settings{}};
    plank_with_boxes(world, 12, 1, {3, 6.25});
    std::vector<BodyId> row;
    row.push_back(world.create_body(at(-.46 - .01 * k, .4, 10), Shape::circle(real(.2)), weighs(20, 0)));
    for (int i = 0; i < 4; ++i) {
      row.push_back(world.create_body(at(.405 * i, .4, -.5 * i), Shape::circle(real(.2)), weighs(1, i == 0 ? 0 : .5)));
    }
    double nearest = 1;
    for (int step = 0; step < 10; ++step) {
      world.step();
      for (std::size_t i = 1; i < row.size(); ++i) {
        const Vec2 apart = world.body(row[i]).position() - world.body(row[i - 1]).position();
        nearest = std::min(nearest, static_cast<double>(length(apart)));
      }
    }
    EXPECT_GT(nearest, .4 - 5e-4) << k;
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::impacts_test
