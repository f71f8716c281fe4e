#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../support.h"
#include "core/method_list.h"
#include "reference/faults/engine/misprinted_article.h"

namespace article_test {
namespace {

using namespace impulse;

/// The method under test, in the default gravity.
Settings falling() {
  Settings settings;
  settings.solver = "article";
  return settings;
}

/// Two discs of these masses meet head on, the left one at 1 m/s and the right one at -2; their speeds afterwards.
struct HeadOn {
  double mass_a = 1, mass_b = 1, restitution = 0;
  double va = 1, vb = -2;

  using Solve = std::array<double, 2> (*)(const HeadOn&);

  /// v1' = ((m1 - e m2) v1 + (1 + e) m2 v2)/(m1 + m2), and the mirror image.
  std::array<double, 2> exact() const {
    const double sum = mass_a + mass_b;
    return {((mass_a - restitution * mass_b) * va + (1 + restitution) * mass_b * vb) / sum,
            ((mass_b - restitution * mass_a) * vb + (1 + restitution) * mass_a * va) / sum};
  }
};

std::array<double, 2> by_the_engine(const HeadOn& meeting) {
  World world(weightless());
  const auto add = [&](double x, double v, double mass) {
    const Material material{real(mass / (M_PI / 4)), 0, 0, real(meeting.restitution)};
    return world.create_body(at(x, 0, v, 0), Shape::circle(Real{0.5}), material);
  };
  const BodyId a = add(0, meeting.va, meeting.mass_a);
  const BodyId b = add(1, meeting.vb, meeting.mass_b);
  world.step();
  return {static_cast<double>(world.body(a).velocity().x), static_cast<double>(world.body(b).velocity().x)};
}

/// j = factor * vn / (1/mA + 1/mB), applied once.
std::array<double, 2> by_one_impulse(const HeadOn& meeting, double factor) {
  const double j = factor * (meeting.vb - meeting.va) / (1 / meeting.mass_a + 1 / meeting.mass_b);
  return {meeting.va - j / meeting.mass_a, meeting.vb + j / meeting.mass_b};
}

bool obeys_the_closed_form(HeadOn::Solve solve) {
  for (const double ratio : {1.0, 3.0, 1e3, 1e6}) {
    for (const double e : {0.0, 0.3, 0.8, 1.0}) {
      for (const HeadOn& meeting : {HeadOn{1, ratio, e}, HeadOn{ratio, 1, e}}) {
        // The impulse is a sum of products each good to a few roundings of the closing speed, 3 m/s.
        const double tolerance = 3 * 16 * static_cast<double>(round_off);
        const auto [a, b] = solve(meeting);
        const auto [exact_a, exact_b] = meeting.exact();
        if (!(std::abs(a - exact_a) <= tolerance && std::abs(b - exact_b) <= tolerance)) return false;
      }
    }
  }
  return true;
}

TEST(Article, CollidesTwoDiscsAsTheClosedForm) { EXPECT_TRUE(obeys_the_closed_form(by_the_engine)); }

TEST(Article, ItsPrintedImpulseDoesNot) {
  EXPECT_TRUE(obeys_the_closed_form([](const HeadOn& m) { return by_one_impulse(m, -(1 + m.restitution)); }));
  EXPECT_FALSE(obeys_the_closed_form([](const HeadOn& m) { return by_one_impulse(m, 1 + m.restitution); }));
  EXPECT_FALSE(obeys_the_closed_form([](const HeadOn& m) { return by_one_impulse(m, -1); }));
}

// J = -(1 + e) vn / (1/m + 1/M + (r x n)^2/I): a disc of pi/4 kg against a box of 4 kg, .5 m off its centre.
TEST(Article, HitsOffCentreAsTheClosedForm) {
  World world(weightless());
  const BodyId box = world.create_body(at(0, 0), Shape::box({1, 1}), frictionless(.5));
  const BodyId disc = world.create_body(at(1.5, .5, -3, 0), Shape::circle(Real{0.5}), frictionless(.5));
  world.step();
  const double k = 1 / (M_PI / 4) + 1.0 / 4 + .25 / (8.0 / 3);
  const double j = 1.5 * 3 / k;
  const double tolerance = 3 * 32 * static_cast<double>(round_off);
  EXPECT_NEAR(world.body(box).velocity().x, -j / 4, tolerance);
  EXPECT_NEAR(world.body(box).angular_velocity(), .5 * j / (8.0 / 3), tolerance);
  EXPECT_NEAR(world.body(disc).velocity().x, -3 + j / (M_PI / 4), tolerance);
  EXPECT_NEAR(world.body(disc).angular_velocity(), 0, tolerance);
}

struct Oblique {
  Vec2 v;
  Real w = 0;
  Real jn = 0, jt = 0;
};

/// A disc of radius .5 and 1 kg meets a floor at (2, -3) m/s; friction and restitution as told.
Oblique hit_floor(double static_friction, double dynamic_friction, double restitution, double vx = 2) {
  World world(weightless());
  const Material rough{real(4 / M_PI), real(static_friction), real(dynamic_friction), real(restitution)};
  add_floor(world, rough);
  const BodyId disc = world.create_body(at(0, .5, vx, -3), Shape::circle(Real{0.5}), rough);
  world.step();
  const std::span<const ContactInfo> contacts = world.contacts();
  if (contacts.size() != 1) return {};
  return {world.body(disc).velocity(), world.body(disc).angular_velocity(), contacts[0].normal_impulse,
          contacts[0].tangent_impulse};
}

constexpr double few = 3 * 16 * static_cast<double>(round_off);

// Jt = min(mu Jn, m vt/3), since a disc's surface answers with 1/m + r^2/I = 3/m.
TEST(Article, SticksWhereFrictionSuffices) {
  const Oblique after = hit_floor(.9, .9, .5);
  EXPECT_NEAR(after.jn, 4.5, few);
  EXPECT_NEAR(after.v.y, 1.5, few);
  EXPECT_NEAR(std::abs(after.jt), 2.0 / 3, few);
  EXPECT_NEAR(after.v.x, 4.0 / 3, few);
  EXPECT_NEAR(after.v.x + after.w * Real{0.5}, 0, few);  // the point of contact stands still
}

TEST(Article, SlidesWhereFrictionDoesNotSuffice) {
  const Oblique after = hit_floor(.1, .1, .5);
  EXPECT_NEAR(std::abs(after.jt), .45, few);
  EXPECT_NEAR(after.v.x, 1.55, few);
  EXPECT_NEAR(after.w, -.45 * .5 / .125, few);
}

// The impulse to stick is 2/3 N s: .15 of the normal impulse of 4.5 N s.
TEST(Article, SticksByTheStaticAndSlidesByTheDynamicCoefficient) {
  EXPECT_NEAR(std::abs(hit_floor(.16, .05, .5).jt), 2.0 / 3, few);
  EXPECT_NEAR(std::abs(hit_floor(.14, .05, .5).jt), 4.5 * .05, few);
}

// With (1 + e), as printed, the surface would bounce back: 1.5 times the impulse that stops it.
TEST(Article, FrictionDoesNotDependOnRestitution) {
  EXPECT_NEAR(std::abs(hit_floor(9, 9, 0).jt), std::abs(hit_floor(9, 9, .5).jt), few);
}

// The print normalises a tangent of length 0 here.
TEST(Article, HandlesAHitWithoutTangentialSpeed) {
  const Oblique after = hit_floor(.5, .5, .5, 0);
  EXPECT_EQ(after.v.x, 0);
  EXPECT_EQ(after.w, 0);
  EXPECT_NEAR(after.v.y, 1.5, few);
}

// Per unit of speed still to gain, each of two points at arms of .5 m gives 1/2 of 1/(1 + .25 * 6) N s to 1 kg:
// together they leave .6 of it, ten times over, of 4.5 m/s.
TEST(Article, BouncesAFlatBoxByItsRestitutionWithoutRotatingIt) {
  World world(weightless());
  add_floor(world, frictionless(.5));
  const BodyId box = world.create_body(at(0, .5, 0, -3), Shape::box({Real{0.5}, Real{0.5}}), frictionless(.5));
  world.step();
  EXPECT_NEAR(world.body(box).velocity().y, 1.5 - 4.5 * std::pow(.6, 10), few);
  EXPECT_NEAR(world.body(box).angular_velocity(), 0, few);
}

// If points saw each other's impulses, friction would act sideways.
TEST(Article, LetsAStraightStackStandStraight) {
  World world(falling());
  add_floor(world);
  world.create_body(at(0, .5), Shape::box({Real{0.5}, Real{0.5}}));
  const BodyId top = world.create_body(at(0, 1.5), Shape::box({Real{0.5}, Real{0.5}}));
  run(world, 300);
  EXPECT_EQ(world.body(top).position().x, 0);
  EXPECT_EQ(world.body(top).angle(), 0);
}

// Equal masses and e = 1: each passes its speed on.
TEST(Article, PassesTheSpeedThroughARowOfTouchingBalls) {
  World world(weightless());
  std::array<BodyId, 5> balls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double x = static_cast<double>(i);
    balls[i] = world.create_body(at(x, 0, i == 0 ? 2 : 0, 0), Shape::circle(Real{0.5}), frictionless(1));
  }
  world.step();
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(world.body(balls[i]).velocity().x, 0, 32 * round_off) << i;
  EXPECT_NEAR(world.body(balls[4]).velocity().x, 2, 32 * round_off);
}

// Gravity alone presses a resting ball into the floor; that is no impact, however bouncy it is.
TEST(Article, LetsASuperBallRest) {
  World world(falling());
  add_floor(world, frictionless(.95));
  const BodyId ball = world.create_body(at(0, .498), Shape::circle(Real{0.5}), frictionless(.95));
  for (int i = 0; i < 120; ++i) {
    world.step();
    ASSERT_LE(world.body(ball).velocity().y, 4 * round_off);
  }
}

// Beyond the slop, .4 of the overlap goes each step: what is left after n steps is .6^n of it.
TEST(Article, RemovesOverlapDownToTheSlop) {
  World world(weightless());
  add_floor(world);
  const BodyId disc = world.create_body(at(0, .4), Shape::circle(Real{0.5}));
  run(world, 10);
  EXPECT_NEAR(world.body(disc).position().y, .495 - .095 * std::pow(.6, 10), 32 * round_off);
  run(world, 50);
  EXPECT_NEAR(world.body(disc).position().y, .495, 64 * round_off);
  EXPECT_EQ(world.body(disc).velocity(), (Vec2{0, 0}));
}

TEST(Article, MovesTheLighterOfTwoOverlappingBodiesFarther) {
  World world(weightless());
  const BodyId light = world.create_body(at(0, 0), Shape::circle(Real{0.5}), {1, 0, 0, 0});
  const BodyId heavy = world.create_body(at(.9, 0), Shape::circle(Real{0.5}), {3, 0, 0, 0});
  world.step();
  const Real moved_light = -world.body(light).position().x;
  const Real moved_heavy = world.body(heavy).position().x - real(.9);
  EXPECT_NEAR(moved_light + moved_heavy, .4 * .095, 16 * round_off);
  EXPECT_NEAR(moved_light, 3 * moved_heavy, 16 * round_off);
}

TEST(Article, NeverPulls) {
  World world(weightless());
  world.create_body(at(0, 0, -1, 0), Shape::circle(Real{0.5}));
  const BodyId b = world.create_body(at(.99, 0, 1, 0), Shape::circle(Real{0.5}));
  world.step();
  EXPECT_EQ(world.body(b).velocity(), (Vec2{1, 0}));
}

// The faults of reference/faults/engine replace formulas in a copy of the method, which must not drift apart from it.
TEST(Article, HasTheBitsOfItsCopyWithoutMisprints) {
  MethodList<Solver>::extend([](std::string_view name) -> std::unique_ptr<Solver> {
    if (name != "copy") return nullptr;
    return std::make_unique<MisprintedArticle<PrintedFormulas>>();
  });
  const auto run_pile = [](const char* solver) {
    Settings settings;
    settings.solver = solver;
    World world(settings);
    const Material material{1, real(.5), real(.3), real(.4)};
    add_floor(world, material);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 8; ++i) {
      const BodyDef def = at(.3 * (i % 3), 1 + 1.1 * i, i % 2, 0);
      bodies.push_back(i % 2 == 0 ? world.create_body(def, Shape::box({real(.5), real(.4)}), material)
                                  : world.create_body(def, Shape::circle(Real{0.5}), material));
    }
    world.create_joint(RevoluteJoint{bodies[0], bodies[1], {0, real(1.5)}});
    run(world, 120);
    std::vector<Real> numbers;
    for (const BodyId id : bodies) {
      const Body body = world.body(id);
      for (const Real number : {body.position().x, body.position().y, body.angle(), body.velocity().x,
                                body.velocity().y, body.angular_velocity()}) {
        numbers.push_back(number);
      }
    }
    return numbers;
  };
  const std::vector<Real> copy = run_pile("copy");
  MethodList<Solver>::extend(nullptr);
  EXPECT_EQ(run_pile("article"), copy);
}

}  // namespace
}  // namespace article_test
