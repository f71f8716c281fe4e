// What every adapter must satisfy in contacts.

#include "tests/reference/adapters/every_engine.h"

#include <cmath>

#include "scenarios/scene/mass.h"

namespace plumb::every_engine_test {
namespace {

TEST_P(EveryEngine, KeepsLayersApart) {
  Body other = ground();
  other.layers = 0b0110;
  Body through = box({0, 1});
  through.layers = 0b1001;
  Body held = box({5, .5});
  held.layers = 0b1100;
  const std::vector<BodyState> states = run(scene_of({other, through, held}), 60);
  EXPECT_LT(states[1].position.y, -3);
  EXPECT_NEAR(states[2].position.y, .5, stated().contact_gap() + rounding(60, 1));
}

// A sliding box slows down by v(t) = v0 - mu g t. The first contact may be found a step late and the last one count
// half: an error of two steps in sixty.
TEST_P(EveryEngine, UsesTheMixedFrictionOfEveryRule) {
  for (const FrictionMixing rule : {FrictionMixing::geometric, FrictionMixing::pythagorean, FrictionMixing::average,
                                    FrictionMixing::min, FrictionMixing::max, FrictionMixing::multiply}) {
    Body slider = body("slider", BodyType::dynamic, {0, .25}, Box{{1, .5}}, {1, .3, .3, 0});
    slider.velocity = {12, 0};
    Scene scene = scene_of({ground(.8), slider});
    scene.mixing.friction = rule;
    const double mu = mixed_dynamic_friction(scene.mixing, scene.bodies[0].shapes[0].surface, slider.shapes[0].surface);
    const double measured = (12 - run(scene, 60).at(1).velocity.x) / g;
    EXPECT_NEAR(measured, mu, mu * 2 / 60) << "rule " << static_cast<int>(rule);
  }
}

TEST_P(EveryEngine, SticksJustBelowTheAngleOfFrictionAndSlidesJustAbove) {
  const double mu = .4;
  const int n = 120;
  for (const double part : {.97, 1.03}) {
    const double slope = std::atan(part * mu);
    Body plane = ground(mu);
    plane.angle = slope;
    Body slider = body("slider", BodyType::dynamic, {-.25 * std::sin(slope), .25 * std::cos(slope)}, Box{{1, .5}},
                       {1, mu, mu, 0});
    slider.angle = slope;
    const BodyState state = run(scene_of({plane, slider}), n).at(1);
    const double speed = std::hypot(state.velocity.x, state.velocity.y);
    const double sliding = g * (std::sin(slope) - mu * std::cos(slope)) * n * dt;
    if (part < 1) {
      EXPECT_LT(speed, stated().creep + rounding(n, 1)) << "sticks";
    } else {
      EXPECT_NEAR(speed, sliding, sliding / 10) << "slides";
    }
  }
}

// Far above every threshold the first rebound has speed e v.
TEST_P(EveryEngine, UsesTheMixedRestitutionOfEveryRule) {
  for (const RestitutionMixing rule :
       {RestitutionMixing::max, RestitutionMixing::min, RestitutionMixing::average, RestitutionMixing::multiply}) {
    Body floor = ground();
    floor.shapes[0].surface.restitution = .9;
    Body ball = body("ball", BodyType::dynamic, {0, 2}, Circle{.5}, {1, .5, .5, .4});
    ball.velocity = {0, -20};
    Scene scene = scene_of({floor, ball});
    scene.gravity = {};
    scene.mixing.restitution = rule;
    const double e = mixed_restitution(scene.mixing, floor.shapes[0].surface, ball.shapes[0].surface);
    EXPECT_NEAR(run(scene, 15).at(1).velocity.y, 20 * e, .02 * 20 * e) << "rule " << static_cast<int>(rule);
  }
}

TEST_P(EveryEngine, RefusesTwoFrictionsOrUsesThem) {
  Body slider = body("slider", BodyType::dynamic, {0, .25}, Box{{1, .5}}, {1, .8, .2, 0});
  slider.velocity = {10, 0};
  Body floor = body("ground", BodyType::fixed, {}, HalfSpace{}, {1, .8, .2, 0});
  const Scene scene = scene_of({floor, slider});
  if (refusal(scene).empty()) {
    EXPECT_NEAR(run(scene, 60).at(1).velocity.x, 10 - .2 * g, .2 * g * 2 / 60);
  } else {
    EXPECT_NE(refusal(scene).find("friction"), std::string::npos);
  }
}

/// The sum of the impulses on body 0.
Vec push_on_ground(const std::vector<ContactState>& contacts) {
  Vec sum;
  for (const ContactState& contact : contacts) {
    if (contact.a != 0 && contact.b != 0) continue;
    const double side = contact.b == 0 ? 1 : -1;
    sum.x += side * (contact.normal_impulse * contact.normal.x - contact.tangent_impulse * contact.normal.y);
    sum.y += side * (contact.normal_impulse * contact.normal.y + contact.tangent_impulse * contact.normal.x);
  }
  return sum;
}

TEST_P(EveryEngine, SupportsARestingBoxByImpulsesOfItsWeight) {
  const Scene scene = scene_of({ground(), box({0, .5})});
  std::vector<ContactState> contacts;
  after(scene, 120)->read_contacts(contacts);
  ASSERT_FALSE(contacts.empty());
  for (const ContactState& contact : contacts) {
    ASSERT_EQ(contact.a + contact.b, 1u);
    EXPECT_GE(contact.normal_impulse, 0);
    EXPECT_NEAR(contact.point.y, 0, stated().contact_gap());
    EXPECT_LT(std::abs(contact.separation), stated().contact_gap());
    EXPECT_LE(std::abs(contact.point.x), .5 + stated().contact_gap());
  }
  // At rest the contact impulse of a step equals the weight times the step.
  const double mass = 1;
  const Vec push = push_on_ground(contacts);
  EXPECT_NEAR(push.y, -mass * g * dt, 1e-3 * mass * g * dt);
  EXPECT_NEAR(push.x, 0, 1e-3 * mass * g * dt);
}

// A second box lands on the sleeping one after 1.48 s and wakes it; then both sleep.
TEST_P(EveryEngine, KeepsContactImpulsesWhileAsleep) {
  Settings settings = GetParam().settings;
  for (const Option& option : engine().options) {
    if (option.key == "sleep" || option.key == "sleeping") settings[option.key] = "on";
  }
  const Scene scene = scene_of({ground(), box({0, .5}), box({0, 12.5})});
  const std::unique_ptr<Simulation> simulation = engine().build(scene, settings);
  for (const int boxes : {1, 2}) {
    for (int i = 0; i < (boxes == 1 ? 80 : 400); ++i) simulation->step(dt);
    std::vector<ContactState> contacts;
    simulation->read_contacts(contacts);
    EXPECT_NEAR(push_on_ground(contacts).y, -boxes * g * dt, 1e-3 * boxes * g * dt) << boxes << " boxes";
  }
}

// On a slope friction carries m g sin(slope), uphill. This tests the direction of the tangent.
TEST_P(EveryEngine, ReportsFrictionUphill) {
  const double slope = .2;
  Body plane = ground();
  plane.angle = slope;
  Body slider = body("slider", BodyType::dynamic, {-.25 * std::sin(slope), .25 * std::cos(slope)}, Box{{1, .5}});
  slider.angle = slope;
  std::vector<ContactState> contacts;
  after(scene_of({plane, slider}), 120)->read_contacts(contacts);
  ASSERT_FALSE(contacts.empty());
  double friction = 0;  // on the slider along the normal turned by +90 degrees, which from a to b points downhill
  for (const ContactState& contact : contacts) friction += contact.tangent_impulse;
  EXPECT_NEAR(std::abs(friction), .5 * g * std::sin(slope) * dt, 2e-3 * g * dt);
}

// Every body comes to rest on every ground at the height given by its geometry, within the stated gap.
TEST_P(EveryEngine, RestsEveryShapeOnEveryGround) {
  const double tilt = .3;
  Body by_angle = ground();
  by_angle.angle = -tilt;
  by_angle.shapes[0].geometry = HalfSpace{{-std::sin(tilt), std::cos(tilt)}, 0};
  const std::vector<std::pair<std::string, Body>> grounds{
      {"half-space", ground()},
      {"half-space turned back by its body", by_angle},
      {"box", body("ground", BodyType::fixed, {}, Box{{20, 2}, {0, -1}, 0})},
      {"polygon", body("ground", BodyType::fixed, {}, Polygon{{{-10, 0}, {-8, -2}, {8, -2}, {10, 0}}})},
      {"segment", body("ground", BodyType::fixed, {}, Segment{{10, 0}, {-10, 0}})},
      {"circle", body("ground", BodyType::fixed, {}, Circle{20, {0, -20}})},
      {"capsule", body("ground", BodyType::fixed, {}, Capsule{{-10, -1}, {10, -1}, 1})},
  };
  const std::vector<std::pair<std::string, Geometry>> shapes{
      {"circle", Circle{.5, {}}},
      {"box", Box{{1, 1}, {}, 0}},
      {"polygon", Polygon{{{.5, -.5}, {-.5, -.5}, {-.5, .5}, {.5, .5}}}},
      {"capsule", Capsule{{-.5, 0}, {.5, 0}, .5}},
  };
  for (const auto& [below, floor] : grounds) {
    for (const auto& [above, geometry] : shapes) {
      Body rider = body("rider", BodyType::dynamic, {0, .5}, geometry);
      rider.angular_damping = 1;
      const Scene scene = scene_of({floor, rider});
      if (!refusal(scene).empty()) continue;
      const BodyState state = run(scene, 120).at(1);
      EXPECT_NEAR(state.position.y, .5, stated().contact_gap() + 1e-4) << above << " on " << below;
      EXPECT_NEAR(state.position.x, 0, 1e-2) << above << " on " << below;
      EXPECT_NEAR(state.velocity.y, 0, 1e-2) << above << " on " << below;
    }
  }
}

}  // namespace
}  // namespace plumb::every_engine_test
