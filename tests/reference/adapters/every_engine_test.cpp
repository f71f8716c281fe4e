// What every adapter must satisfy. Each test runs for every engine that is not a closed form, with its default settings
// and with every other solver, broad phase and precision that it offers; and for every program of
// reference/programs/npm that is installed in the folder that the environment variable PLUMB_ENGINES_DIR names.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/programs/program_engine.h"
#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

namespace plumb::every_engine_test {
namespace {

constexpr double g = 10;
constexpr double dt = 1.0 / 60;

Body body(std::string name, BodyType type, Vec position, Geometry geometry, Surface surface = {1, .5, .5, 0}) {
  Body made;
  made.name = std::move(name);
  made.type = type;
  made.position = position;
  made.shapes.push_back({std::move(geometry), surface});
  return made;
}

Body ground(double friction = .5) {
  return body("ground", BodyType::fixed, {}, HalfSpace{}, {1, friction, friction, 0});
}

Body box(Vec position, double friction = .5) {
  return body("box", BodyType::dynamic, position, Box{}, {1, friction, friction, 0});
}

Scene scene_of(std::vector<Body> bodies) {
  Scene scene;
  scene.name = "test";
  scene.gravity = {0, -g};
  scene.duration = 2;
  scene.bodies = std::move(bodies);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) scene.bodies[i].name += " " + std::to_string(i);
  return scene;
}

struct TestedEngine {
  std::string name;
  Settings settings;
};

// What a program does otherwise by its own design, which its adapter cannot mend: reports call it wrong there.
struct Deviation {
  std::string_view engine, test, reason;
};
constexpr std::string_view no_coulomb = "loses mu px a step while it slides, whatever the load";
constexpr std::string_view no_contacts = "caches the impulses of slow contacts only, and so reports none";
constexpr Deviation deviations[] = {
    {"matter", "UsesTheMixedFrictionOfEveryRule", no_coulomb},
    {"matter", "SticksJustBelowTheAngleOfFrictionAndSlidesJustAbove", no_coulomb},
    {"matter", "UsesTheMixedRestitutionOfEveryRule",
     "a disc is a polygon: landing on a side, two corners divide the impulse and lose part of it"},
    {"matter", "SupportsARestingBoxByImpulsesOfItsWeight", no_contacts},
    {"matter", "KeepsContactImpulsesWhileAsleep", no_contacts},
    {"matter", "ReportsFrictionUphill", no_contacts},
};

void PrintTo(const TestedEngine& config, std::ostream* out) {
  *out << config.name;
  for (const auto& [key, value] : config.settings) *out << ' ' << key << '=' << value;
}

class EveryEngine : public testing::TestWithParam<TestedEngine> {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    for (const Deviation& known : deviations) {
      if (engine().name == known.engine && test.starts_with(known.test)) GTEST_SKIP() << known.reason;
    }
  }

  const Engine& engine() const {
    const Engine* const built_in = Catalog<Engine>::find(GetParam().name);
    return built_in != nullptr ? *built_in : engine_of_program(GetParam().name);
  }
  Stepping stated() const { return engine().stepping(GetParam().settings, dt); }
  // A program is only asked when it builds, and never of a scene that cannot be written.
  std::string refusal(const Scene& scene) const {
    std::string reason = engine().unsupported(scene, GetParam().settings);
    if (!reason.empty()) return reason;
    try {
      engine().build(scene, GetParam().settings);
    } catch (const std::domain_error& error) {
      return error.what();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  std::unique_ptr<Simulation> after(const Scene& scene, int steps) const {
    std::unique_ptr<Simulation> simulation = engine().build(scene, GetParam().settings);
    for (int i = 0; i < steps; ++i) simulation->step(dt);
    return simulation;
  }

  static std::vector<BodyState> read(const Scene& scene, const Simulation& simulation) {
    std::vector<BodyState> states(scene.bodies.size());
    simulation.read(states);
    return states;
  }

  std::vector<BodyState> run(const Scene& scene, int steps) const { return read(scene, *after(scene, steps)); }

  /// Bound on the round-off of n steps, with all their sub-steps, of a value of that size. matter keeps positions
  /// alone: its velocities are their differences, divided by the step.
  double rounding(int n, double size) const {
    const double amplified = engine().name == "matter" ? 1 / dt : 1;
    return amplified * 2 * n * (dt / stated().h) * stated().epsilon * size;
  }
};

TEST_P(EveryEngine, FallsAsItsStatedDriftSays) {
  const int n = 60;
  const BodyState fallen = run(scene_of({box({0, 10})}), n).at(0);
  const Stepping is = stated();
  const double t = n * dt;
  EXPECT_NEAR(fallen.position.y, 10 - g * t * t / 2 - is.drift * g * t * is.h, rounding(n, 2 * 10));
  EXPECT_NEAR(fallen.velocity.y, -g * t, rounding(n, g * t));
}

TEST_P(EveryEngine, ReportsStatesInSceneOrder) {
  const Scene scene = scene_of({box({0, 5}), ground(), box({3, 7}), box({6, 9})});
  const std::vector<BodyState> states = run(scene, 0);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    EXPECT_NEAR(states[i].position.x, scene.bodies[i].position.x, rounding(1, 10));
    EXPECT_NEAR(states[i].position.y, scene.bodies[i].position.y, rounding(1, 10));
  }
}

// An L of two boxes, turned: its centre of mass is not its origin.
TEST_P(EveryEngine, StartsAndSpinsAboutTheCentreOfMass) {
  Body el = body("el", BodyType::dynamic, {1, 2}, Box{{2, .5}, {1, .25}, 0});
  el.shapes.push_back({Box{{.5, 1}, {.25, 1}, 0}, {3, .5, .5, 0}});
  el.angle = .7;
  el.velocity = {.3, -.2};
  el.angular_velocity = 2;
  el.gravity_scale = 0;
  const Scene scene = scene_of({el});
  const Vec c = mass_of(el).center;
  const Vec start{1 + std::cos(.7) * c.x - std::sin(.7) * c.y, 2 + std::sin(.7) * c.x + std::cos(.7) * c.y};
  const int n = 60;
  const BodyState state = run(scene, n).at(0);
  EXPECT_NEAR(state.position.x, start.x + .3 * n * dt, rounding(n, 3));
  EXPECT_NEAR(state.position.y, start.y - .2 * n * dt, rounding(n, 3));
  // A rotation kept as cosine and sine may advance by atan(w h) = w h - (w h)^3/3.
  EXPECT_NEAR(state.angle, .7 + 2 * n * dt, rounding(n, 3) + n * dt * std::pow(2, 3) * stated().h * stated().h / 3);
  EXPECT_NEAR(state.angular_velocity, 2, rounding(n, 2));
}

TEST_P(EveryEngine, TakesMassAndInertiaFromTheScene) {
  Body el = body("el", BodyType::dynamic, {}, Box{{2, .5}, {1, .25}, 0});
  el.shapes.push_back({Circle{.4, {.25, 1}}, {3, .5, .5, 0}});
  Scene scene = scene_of({el});
  scene.gravity = {};
  scene.forces.push_back(Constant{0, {4, -2}, 3});
  if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
  const Mass mass = mass_of(el);
  const BodyState state = run(scene, 1).at(0);
  EXPECT_NEAR(state.velocity.x, 4 / mass.mass * dt, rounding(8, .1));
  EXPECT_NEAR(state.velocity.y, -2 / mass.mass * dt, rounding(8, .1));
  EXPECT_NEAR(state.angular_velocity, 3 / mass.inertia * dt, rounding(8, .1));
}

TEST_P(EveryEngine, FixesRotationAndScalesGravity) {
  Body still = box({0, 5});
  still.fixed_rotation = true;
  still.gravity_scale = -.5;
  Scene scene = scene_of({still});
  scene.forces.push_back(Constant{0, {}, 3});
  if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
  const BodyState state = run(scene, 60).at(0);
  EXPECT_EQ(state.angular_velocity, 0);
  EXPECT_NEAR(state.velocity.y, .5 * g, rounding(60, g));
}

TEST_P(EveryEngine, MovesKinematicBodiesAtTheirVelocity) {
  Body lift = body("lift", BodyType::kinematic, {0, 1}, Box{{4, 1}});
  lift.velocity = {.5, 1};
  lift.angular_velocity = -.25;
  const BodyState state = run(scene_of({lift}), 60).at(0);
  EXPECT_NEAR(state.position.x, .5, rounding(60, 1));
  EXPECT_NEAR(state.position.y, 2, rounding(60, 2));
  EXPECT_NEAR(state.angle, -.25, rounding(60, 1) + std::pow(.25, 3) * stated().h * stated().h / 3);
}

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

TEST_P(EveryEngine, SwingsAPendulumOnItsRod) {
  for (const bool hinge : {false, true}) {
    Scene scene = scene_of({body("pivot", BodyType::fixed, {0, 0}, Circle{.1}), box({2, 0})});
    if (hinge) {
      scene.joints.push_back(Revolute{0, 1, {0, 0}});
    } else {
      scene.joints.push_back(Distance{0, 1, {0, 0}, {2, 0}, 2, 0, 0});
    }
    if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
    const BodyState bob = run(scene, 30).at(1);
    EXPECT_LT(bob.position.y, -.5);
    EXPECT_NEAR(std::hypot(bob.position.x, bob.position.y), 2, .01);
  }
}

TEST_P(EveryEngine, HingesABodyToAFixedBodyWithoutShapes) {
  Scene scene = scene_of({{.name = "hook", .type = BodyType::fixed}, box({2, 0})});
  scene.joints.push_back(Revolute{0, 1, {0, 0}});
  const std::string reason = refusal(scene);
  if (reason.find("joints") != std::string::npos) GTEST_SKIP() << reason;
  EXPECT_EQ(reason, "");
  const BodyState bob = run(scene, 30).at(1);
  EXPECT_LT(bob.position.y, -.5);
  EXPECT_NEAR(std::hypot(bob.position.x, bob.position.y), 2, .01);
}

TEST_P(EveryEngine, SlidesOnARailAndKeepsAWeld) {
  Scene rail = scene_of({body("rail", BodyType::fixed, {0, 0}, Circle{.1}), box({3, 4})});
  rail.joints.push_back(Prismatic{0, 1, {3, 4}, {std::sqrt(.5), -std::sqrt(.5)}});
  if (!refusal(rail).empty()) GTEST_SKIP() << refusal(rail);
  const BodyState car = run(rail, 60).at(1);
  EXPECT_NEAR(car.position.x - 3, -(car.position.y - 4), .01);
  EXPECT_NEAR(car.position.x - 3, g / 4, g / 4 * .05);
  EXPECT_NEAR(car.angle, 0, .01);

  Scene welded = scene_of({box({0, 5}), box({1, 5})});
  welded.bodies[0].angular_velocity = 1;
  welded.joints.push_back(Weld{0, 1, {.5, 5}});
  if (!refusal(welded).empty()) GTEST_SKIP() << refusal(welded);
  const std::vector<BodyState> pair = run(welded, 60);
  EXPECT_NEAR(pair[0].angle, pair[1].angle, .01);
  EXPECT_NEAR(std::hypot(pair[1].position.x - pair[0].position.x, pair[1].position.y - pair[0].position.y), 1, .01);
}

TEST_P(EveryEngine, StopsASliderAtBothOfItsLimits) {
  for (const double way : {1.0, -1.0}) {
    Scene rail = scene_of({body("rail", BodyType::fixed, {0, 0}, Circle{.1}), box({3, 4})});
    rail.joints.push_back(Prismatic{0, 1, {3, 4}, {0, way * 2}, Limits{-.5, .75}});
    if (!refusal(rail).empty()) GTEST_SKIP() << refusal(rail);
    EXPECT_NEAR(run(rail, 120).at(1).position.y, way > 0 ? 3.5 : 3.25, .01);
  }
}

TEST_P(EveryEngine, TakesKinematicBodiesAlongTheirPaths) {
  Body lift = body("lift", BodyType::kinematic, {1, 2}, Circle{.1});
  lift.velocity = {.5, 0};
  lift.path = Path{.amplitude = {.1, .3}, .frequency = .8, .phase = .4};
  const Scene scene = scene_of({lift});
  if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
  constexpr int n = 100;
  const BodyState start = run(scene, 0).at(0);
  const BodyState end = run(scene, n).at(0);
  const double t = n * dt;
  const double moved = std::sin(2 * std::numbers::pi * .8 * t + .4) - std::sin(.4);
  EXPECT_NEAR(start.velocity.y, .3 * 2 * std::numbers::pi * .8 * std::cos(.4), rounding(1, 2));
  EXPECT_NEAR(end.position.x, 1 + .5 * t + .1 * moved, rounding(n, 4));
  EXPECT_NEAR(end.position.y, 2 + .3 * moved, rounding(n, 4));
}

TEST_P(EveryEngine, RefusesBodiesWithoutMass) {
  Body ghost = box({0, 1});
  ghost.shapes[0].surface.density = 0;
  EXPECT_NE(refusal(scene_of({ghost})), "");
}

TEST_P(EveryEngine, RepeatsItselfExactly) {
  Scene scene = scene_of({ground(), box({0, .6}), box({.3, 1.7}), box({-.2, 2.8})});
  const std::vector<BodyState> once = run(scene, 90);
  const std::vector<BodyState> again = run(scene, 90);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].position, again[i].position);
    EXPECT_EQ(once[i].angle, again[i].angle);
  }
}

TEST_P(EveryEngine, StatesWhereItComesFrom) {
  EXPECT_NE(engine().about, "");
  EXPECT_NE(engine().source, "");
  EXPECT_GT(stated().h, 0);
  EXPECT_GT(stated().epsilon, 0);
}

std::vector<TestedEngine> configs() {
  std::vector<TestedEngine> all;
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (engine->exact) continue;
    all.push_back({engine->name, {}});
    for (const Option& option : engine->options) {
      if (option.key != "solver" && option.key != "broad-phase" && option.key != "precision") continue;
      for (const auto& [choice, about] : option.choices) {
        if (choice != option.value) all.push_back({engine->name, {{option.key, choice}}});
      }
    }
  }
  return all;
}

// Commands of the programs that are installed.
std::vector<TestedEngine> installed() {
  std::vector<TestedEngine> all;
  const char* const folder = std::getenv("PLUMB_ENGINES_DIR");
  if (folder == nullptr) return all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path adapter = entry.path() / "adapter.mjs";
    const bool half_installed = entry.path().filename().string().find(".part-") != std::string::npos;
    if (!half_installed && std::filesystem::exists(adapter)) all.push_back({"node " + adapter.string(), {}});
  }
  std::ranges::sort(all, {}, &TestedEngine::name);
  return all;
}

std::string test_name(const testing::TestParamInfo<TestedEngine>& info) {
  std::string name = testing::PrintToString(info.param);
  const std::size_t adapter = name.find("/adapter.mjs");
  if (adapter != std::string::npos) name = name.substr(name.rfind('/', adapter - 1) + 1, adapter);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Adapters, EveryEngine, testing::ValuesIn(configs()), test_name);
INSTANTIATE_TEST_SUITE_P(Programs, EveryEngine, testing::ValuesIn(installed()), test_name);

TEST(Programs, AreInstalled) {
  if (installed().empty()) {
    GTEST_SKIP() << "no programs are tested: PLUMB_ENGINES_DIR names no folder with a sub-folder for each engine "
                    "(adapter.mjs, plumb_engine.mjs, node_modules)";
  }
}

}  // namespace
}  // namespace plumb::every_engine_test
