// Loads and limits with closed forms, to round-off.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../support.h"

namespace {

using namespace impulse;

constexpr bool is_double = sizeof(Real) == sizeof(double);
constexpr double g = 10;
constexpr double dt = 1.0 / 60;

/// The bound for loads, in parts of themselves: of what the geometry's rounding leaves.
constexpr double load_bound = is_double ? 1e-9 : 1e-4;

Settings with(const char* solver) {
  Settings settings;
  settings.solver = solver;
  return settings;
}

Settings exact() { return with("exact"); }

BodyDef fixed(double x, double y, double angle = 0) {
  BodyDef def = at(x, y);
  def.type = BodyType::fixed;
  def.angle = real(angle);
  return def;
}

/// Normal loads (N) between pairs of bodies, by index.
std::map<std::pair<std::uint32_t, std::uint32_t>, double> loads(const World& world) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> sum;
  for (const ContactInfo& contact : world.contacts()) {
    sum[{contact.a.index, contact.b.index}] += static_cast<double>(contact.normal_impulse) / dt;
  }
  return sum;
}

TEST(Exact, FindsTheLoadsOfAStackInItsFirstStep) {
  World world(exact());
  add_floor(world);
  for (int i = 0; i < 10; ++i) world.create_body(at(0, .5 + i), Shape::box({real(.5), real(.5)}));
  for (int step = 0; step < 60; ++step) {
    world.step();
    const auto found = loads(world);
    for (std::uint32_t i = 0; i < 10; ++i) {
      EXPECT_NEAR(found.at({i, i + 1}) / (g * (10 - i)), 1, load_bound) << "contact " << i << ", step " << step;
    }
  }
}

// Levers: a plank of 8 kg on two round supports at -1.5 and 1 m, a disc on it at .25 m.
TEST(Exact, SharesABeamsLoadByTheLawOfLevers) {
  World world(exact());
  const Material slick = frictionless();
  world.create_body(fixed(-1.5, -.5), Shape::circle(real(.5)), slick);
  world.create_body(fixed(1, -.5), Shape::circle(real(.5)), slick);
  world.create_body(at(0, .5), Shape::box({2, real(.5)}), {2, 0, 0, 0});
  const BodyId disc = world.create_body(at(.25, 1.5), Shape::circle(real(.5)), {4, 0, 0, 0});
  world.step();
  const double plank = 8 * g;
  const double load = static_cast<double>(world.body(disc).mass().mass) * g;
  const double right = (plank * 1.5 + load * 1.75) / 2.5;
  const auto found = loads(world);
  EXPECT_NEAR(found.at({1, 2}) / right, 1, load_bound);
  EXPECT_NEAR(found.at({0, 2}) / (plank + load - right), 1, load_bound);
  EXPECT_NEAR(found.at({2, 3}) / load, 1, load_bound);
}

// tan(slope) = mu (1 -+ 1e-4): it sticks to the last bit on one side, and slides on the other with the difference.
TEST(Exact, SeparatesStickingFromSlidingAtTheAngleOfFriction) {
  const double mu = .5;
  for (const double part : {1 - 1e-4, 1 + 1e-4}) {
    const double slope = std::atan(mu * part);
    World world(exact());
    const Material rough{1, real(mu), real(mu), 0};
    world.create_body(fixed(0, 0, slope), Shape::half_space({0, 1}, 0), rough);
    BodyDef def = at(-.5 * std::sin(slope), .5 * std::cos(slope));
    def.angle = real(slope);
    const BodyId box = world.create_body(def, Shape::box({real(.5), real(.5)}), rough);
    run(world, 60);
    const double speed = static_cast<double>(length(world.body(box).velocity()));
    const double slides = g * (std::sin(slope) - mu * std::cos(slope));
    EXPECT_NEAR(speed, part < 1 ? 0 : slides, is_double ? 1e-9 : 1e-4) << part;
  }
}

TEST(Exact, SlidesWithTheDynamicCoefficientOnceTheStaticOneIsExceeded) {
  for (const double pull : {5.9, 6.1}) {
    World world(exact());
    const Material rough{1, real(.6), real(.4), 0};
    add_floor(world, rough);
    const BodyId box = world.create_body(at(0, .5), Shape::box({real(.5), real(.5)}), rough);
    for (int i = 0; i < 60; ++i) {
      world.body(box).apply_force({real(pull), 0});
      world.step();
    }
    EXPECT_NEAR(world.body(box).velocity().x, pull < 6 ? 0 : pull - 4, is_double ? 1e-9 : 1e-4) << pull << " N";
  }
}

// The corner is hit with J = -(1 + e) vn / (1/m + rx^2/I), independent of the other corner.
TEST(Exact, HitsACornerByTheLawOfImpacts) {
  World world(weightless());
  Settings settings = exact();
  settings.gravity = {};
  world.set_settings(settings);
  add_floor(world, frictionless(.5));
  const double angle = .3;
  const double rx = -.5 * std::cos(angle) + .5 * std::sin(angle);
  BodyDef def = at(0, .5 * (std::cos(angle) + std::sin(angle)), 0, -3);
  def.angle = real(angle);
  const BodyId box = world.create_body(def, Shape::box({real(.5), real(.5)}), frictionless(.5));
  run(world, 3);
  const double j = 1.5 * 3 / (1 + 6 * rx * rx);
  // It may have turned on for a step before it hit.
  EXPECT_NEAR(world.body(box).velocity().y, -3 + j, is_double ? 1e-9 : 1e-5);
  EXPECT_NEAR(world.body(box).angular_velocity(), 6 * rx * j, is_double ? 1e-9 : 1e-5);
}

TEST(Exact, AgreesWithTheDefaultMethodOnTheLoadsOfAPyramid) {
  std::vector<double> floor_loads;
  for (const char* solver : {"exact", "accurate"}) {
    World world(with(solver));
    add_floor(world);
    for (int row = 0; row < 2; ++row) {
      for (int i = 0; i < 2 - row; ++i) {
        world.create_body(at(1.5 * (i + .5 * row), .5 + row), Shape::box({real(.5), real(.5)}), frictionless());
      }
    }
    run(world, 240);
    for (const auto& [pair, load] : loads(world)) {
      if (pair.first == 0) floor_loads.push_back(load);
    }
  }
  ASSERT_EQ(floor_loads.size(), 4U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(floor_loads[i] / 15, 1, load_bound);
    EXPECT_NEAR(floor_loads[i] / floor_loads[i + 2], 1, 1e-3);
  }
}

// The lowest box bears 1110 times its weight; a load of nothing but equals is all that float's impulses tell apart.
TEST(Exact, HoldsATowerWithinItsStatedGapAndCreep) {
  const Settings settings = exact();
  const auto creep = static_cast<double>(stated_errors(settings).creep);
  const auto gap = static_cast<double>(stated_errors(settings).gap);
  World world(settings);
  add_floor(world);
  std::vector<BodyId> boxes;
  for (int i = 0; i < 4; ++i) {
    Material made_of;
    made_of.density = is_double ? real(std::pow(10, i)) : 1;
    boxes.push_back(world.create_body(at(0, .5 + i), Shape::box({real(.5), real(.5)}), made_of));
  }
  for (int step = 1; step <= 240; ++step) {
    world.step();
    for (int i = 0; i < 4; ++i) {
      const Body box = world.body(boxes[static_cast<std::size_t>(i)]);
      EXPECT_LE(std::abs(static_cast<double>(box.velocity().x)), creep) << "step " << step;
      EXPECT_LE(std::abs(static_cast<double>(box.position().x)), creep * step * dt) << "step " << step;
      EXPECT_NEAR(box.position().y, .5 + i, (i + 1) * gap) << "step " << step;
    }
  }
}

// Blocks stepped out beyond the harmonic series, of which all but one corner each part in one of the first steps.
TEST(Exact, ReportsAllItsImpulses) {
  World world(exact());
  add_floor(world, {1, real(.5), real(.5), 0});
  std::vector<BodyId> blocks;
  double x = 0;
  for (int k = 4; k >= 1; --k) {
    blocks.push_back(
        world.create_body(at(x, .25 + .5 * (4 - k)), Shape::box({1, real(.25)}), {1, real(.5), real(.5), 0}));
    x += 1.01 / std::max(k - 1, 1);
  }
  for (int step = 0; step < 12; ++step) {
    std::vector<Vec2> missing;
    for (const BodyId id : blocks) missing.push_back(-world.body(id).mass().mass * world.body(id).velocity());
    world.step();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Real mass = world.body(blocks[i]).mass().mass;
      missing[i] += mass * (world.body(blocks[i]).velocity() - world.settings().dt * world.gravity());
      for (const ContactInfo& contact : world.contacts()) {
        const Vec2 impulse =
            contact.normal_impulse * contact.normal + contact.tangent_impulse * perpendicular(contact.normal);
        if (contact.a == blocks[i]) missing[i] += impulse;
        if (contact.b == blocks[i]) missing[i] -= impulse;
      }
      // What is rounded are the speeds and impulses of a step, of which the largest is that below: four times m g dt.
      EXPECT_LE(length(missing[i]), 64 * round_off * 4 * mass * real(g * dt)) << "step " << step << ", block " << i;
    }
  }
}

TEST(Exact, RefusesIslandsThatAreTooLarge) {
  World world(exact());
  add_floor(world);
  for (int i = 0; i < 13; ++i) world.create_body(at(0, .5 + i), Shape::box({real(.5), real(.5)}));
  try {
    world.step();
    FAIL() << "13 boxes hang together by 26 points";
  } catch (const std::domain_error& refused) {
    EXPECT_NE(std::string(refused.what()).find("at most 24 connected points"), std::string::npos) << refused.what();
  }
}

TEST(Exact, RefusesJoints) {
  World world(exact());
  const BodyId a = world.create_body(at(0, 0), Shape::circle(1));
  const BodyId b = world.create_body(at(3, 0), Shape::circle(1));
  RevoluteJoint joint;
  joint.a = a;
  joint.b = b;
  world.create_joint(joint);
  EXPECT_THROW(world.step(), std::domain_error);
}

TEST(Exact, SolvesAnyNumberOfSeparatePiles) {
  World world(exact());
  add_floor(world);
  for (int i = 0; i < 40; ++i) world.create_body(at(2 * i, .5), Shape::box({real(.5), real(.5)}));
  EXPECT_NO_THROW(run(world, 10));
}

}  // namespace
