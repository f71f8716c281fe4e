// Requirements on every solver, within its own stated errors (impulse::stated_errors).
#include "solver/solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "worlds.h"

namespace solver_test {
namespace {

using namespace impulse;

constexpr double dt = 1.0 / 60;

class EverySolver : public testing::TestWithParam<std::string> {
 protected:
  Settings settings() const {
    Settings chosen;
    chosen.solver = GetParam();
    return chosen;
  }
  StatedErrors stated() const { return stated_errors(settings()); }
};

// Head on, v' = v - (1 + e) m u / (1/mA + 1/mB). They meet in the 15th step, 2 mm deep, so that nothing needs to be
// pushed apart: what Baumgarte's velocities add to an impact is a test of its own. A method that finds velocities from
// positions 1.5 m from the origin knows them to their rounding over h.
TEST_P(EverySolver, CollidesTwoDiscsByTheLawOfImpactsAndConservesMomentum) {
  for (const double e : {0.0, .5, 1.0}) {
    for (const double density : {1.0, 10.0, 100.0}) {
      Settings chosen = weightless();
      chosen.solver = GetParam();
      World world(chosen);
      Material heavy = material(e, 0);
      heavy.density = real(density);
      const BodyId a = world.create_body(at(-1.5, 0, 3), Shape::circle(real(.5)), material(e, 0));
      const BodyId b = world.create_body(at(.498, 0, -1), Shape::circle(real(.5)), heavy);
      run(world, 60);
      const double ma = world.body(a).mass().mass;
      const double mb = world.body(b).mass().mass;
      const double j = (1 + e) * 4 / (1 / ma + 1 / mb);
      const double tolerance = 64 * static_cast<double>(round_off) * 1.5 / static_cast<double>(stated().h);
      EXPECT_NEAR(world.body(a).velocity().x, 3 - j / ma, tolerance) << "e " << e << ", density " << density;
      EXPECT_NEAR(world.body(b).velocity().x, -1 + j / mb, tolerance) << "e " << e << ", density " << density;
      EXPECT_NEAR(ma * world.body(a).velocity().x + mb * world.body(b).velocity().x, 3 * ma - mb, tolerance * ma);
      EXPECT_EQ(world.body(a).velocity().y, 0);
      EXPECT_EQ(world.body(a).angular_velocity(), 0);
    }
  }
}

// The stated gap is that of one body's weight; contact i from the top bears i of them. The article's method keeps no
// impulses from iteration to iteration: its stack leans farther with every step, until after 8 s all lies on the floor.
TEST_P(EverySolver, HoldsAStackOfFiveIfItKeepsImpulses) {
  for (const unsigned seed : {1U, 2U}) {
    std::mt19937 random(seed);
    World world(settings());
    ground(world, material(0, .6));
    std::vector<BodyId> boxes;
    std::vector<double> xs;
    for (int i = 0; i < 5; ++i) {
      xs.push_back(seeded(random, -.002, .002));
      boxes.push_back(world.create_body(at(xs.back(), .5 + i), Shape::box(vec(.5, .5)), material(0, .6)));
    }
    run(world, 480);
    if (GetParam() == "article") {
      EXPECT_LT(world.body(boxes.back()).position().y, 1) << "seed " << seed;
      continue;
    }
    double gaps = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Body body = world.body(boxes[i]);
      gaps += static_cast<double>(5 - i);
      EXPECT_NEAR(body.position().x, xs[i], .01);
      EXPECT_NEAR(body.position().y, .5 + static_cast<double>(i), gaps * static_cast<double>(stated().gap) + 1e-4);
    }
  }
}

TEST_P(EverySolver, SticksBelowTheAngleOfFriction) {
  const double mu = .5;
  const double a = std::atan(mu) - .02;
  World world(settings());
  ground(world, material(0, mu), a);
  const BodyId box =
      world.create_body(tilted(-.5 * std::sin(a), .5 * std::cos(a), a), Shape::box(vec(.5, .5)), material(0, mu));
  run(world, 30);
  const Vec2 soon = world.body(box).position();
  run(world, 120);
  const double moved = static_cast<double>(length(world.body(box).position() - soon));
  EXPECT_LE(moved, 2 * static_cast<double>(stated().creep) + 1e-4);
}

// a = g (sin - mu cos). A contact may be found a step late, and the step begins with all of g.
TEST_P(EverySolver, SlidesBeyondItWithCoulombsAcceleration) {
  const double mu = .2;
  const double a = .5;
  World world(settings());
  ground(world, material(0, mu), a);
  const BodyId box =
      world.create_body(tilted(-.5 * std::sin(a), .5 * std::cos(a), a), Shape::box(vec(.5, .5)), material(0, mu));
  run(world, 60);
  EXPECT_NEAR(length(world.body(box).velocity()), g * (std::sin(a) - mu * std::cos(a)), g * dt);
}

// The apex is (e v)^2/(2 g). An impact noticed `lag` late is g lag too fast and has lost e v lag of its way back; the
// flights, v/g and e v/g long, are off by the integrator's drift.
TEST_P(EverySolver, BouncesAsHighAsItsStatedErrorsAllow) {
  const double e = .8;
  for (const double height : {1.0, 1.3, 2.1}) {
    World world(settings());
    ground(world, material(e, 0));
    const BodyId ball = world.create_body(at(0, .5 + height), Shape::circle(real(.5)), material(e, 0));
    while (world.body(ball).velocity().y <= 0) world.step();
    double apex = 0;
    while (world.body(ball).velocity().y > 0) {
      world.step();
      apex = std::max(apex, static_cast<double>(world.body(ball).position().y) - .5);
    }
    const StatedErrors errors = stated();
    const double h = static_cast<double>(errors.h);
    const double lag = static_cast<double>(errors.impact_lag) * h;
    const double v = std::sqrt(2 * g * height);
    const double drifted = static_cast<double>(std::abs(errors.drift)) * h * (1 + e) * v;
    const double sampled = g * dt * dt / 2;
    EXPECT_NEAR(apex, e * e * height, e * (1 + e) * v * lag + drifted + sampled) << height << " m";
  }
}

// Boxes and discs that fall into a pile without restitution: even with the energy added by removing overlap, a pile
// never has more than at the start, and ends with less.
TEST_P(EverySolver, NeverAddsEnergyToAPile) {
  World world(settings());
  ground(world, material(0, .5));
  std::mt19937 random(7);
  const auto between = [&random](double low, double high) { return seeded(random, low, high); };
  for (int i = 0; i < 8; ++i) {
    const Shape shape =
        i % 2 == 0 ? Shape::box(vec(between(.3, .5), between(.3, .5))) : Shape::circle(real(between(.3, .5)));
    world.create_body(tilted(between(-.5, .5), 1 + 1.5 * i, between(0, 1)), shape, material(0, .5));
  }
  const double before = energy(world);
  double most = before;
  for (int i = 0; i < 300; ++i) {
    world.step();
    most = std::max(most, energy(world));
  }
  EXPECT_LE(most, before * (1 + 1e-5));
  EXPECT_LT(energy(world), before / 2);
}

// Small piles, of which one is thrown up, one bounces, one bears ten times its weight; neighbours in the world, yet far
// apart. Stepping several at once must not change the bits.
TEST_P(EverySolver, GivesIsolatedBodiesTheBitsTheyHaveAlone) {
  constexpr int piles = 24;
  const auto ends_of = [&](int only) {
    World world(settings());
    ground(world, material(0, .5));
    std::vector<BodyId> ids;
    for (int pile = 0; pile < piles; ++pile) {
      if (only >= 0 && only != pile) continue;
      const int kind = pile / 3 % 4;
      const double restitution = kind == 3 ? .4 : 0;
      for (int i = 0; i < 3; ++i) {
        Material made_of = material(restitution, .1 * (pile % 7));
        if (kind == 1 && i == 2) made_of.density = 10;
        BodyDef def = tilted(5 * pile + .02 * i, (kind == 2 ? 9 : .6) + 1.02 * i, .01 * pile);
        def.velocity = vec(.1 * i, kind == 2 ? 7 : 0);
        ids.push_back(
            world.create_body(def, (pile + i) % 3 == 0 ? Shape::circle(real(.5)) : Shape::box(vec(.5, .5)), made_of));
      }
    }
    run(world, 60);
    std::vector<Real> ends;
    for (const BodyId id : ids) {
      const Body body = world.body(id);
      for (const Real x : {body.position().x, body.position().y, body.angle(), body.velocity().x, body.velocity().y,
                           body.angular_velocity()}) {
        ends.push_back(x);
      }
    }
    return ends;
  };
  std::vector<Real> each_alone;
  for (int pile = 0; pile < piles; ++pile) {
    const std::vector<Real> alone = ends_of(pile);
    each_alone.insert(each_alone.end(), alone.begin(), alone.end());
  }
  EXPECT_EQ(ends_of(-1), each_alone);
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const MethodInfo& solver : solvers()) list.push_back(solver.name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Solvers, EverySolver, testing::ValuesIn(names()), [](const auto& entry) {
  std::string name = entry.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace solver_test
