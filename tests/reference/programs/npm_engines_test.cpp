// What theory says of the programs of reference/programs/npm, to 1 %. They are tested if the environment variable
// PLUMB_ENGINES_DIR names a folder where they are installed; every_engine.h has what all adapters must satisfy.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "reference/programs/program_engine.h"
#include "scenarios/allowance.h"
#include "scenarios/sag.h"
#include "scenarios/scene/vec.h"
#include "tests/reference/adapters/scenes.h"
#include "tests/reference/adapters/soft_step.h"

namespace plumb::adapter_tests {
namespace {

constexpr double g = 10;
constexpr double dt = 1.0 / 60;

// Both split a step into four sub-steps and make contacts damped springs.
class SoftStepProgram : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("PLUMB_ENGINES_DIR");
    if (folder == nullptr) GTEST_SKIP() << "PLUMB_ENGINES_DIR names no folder with installed engines";
    adapter_ = std::filesystem::path(folder) / GetParam() / "adapter.mjs";
    if (!std::filesystem::exists(adapter_)) GTEST_SKIP() << adapter_ << " is not installed";
  }

  const Engine& engine() const { return engine_of_program("node " + adapter_.string()); }

  static Scene named(std::vector<Body> bodies) {
    Scene scene = scene_of(std::move(bodies));
    scene.name = "test";
    scene.gravity = {0, -g};
    scene.duration = 10;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) scene.bodies[i].name = "body " + std::to_string(i);
    return scene;
  }

 private:
  std::filesystem::path adapter_;
};

// v += g h, then x += v h: off by g t h/2, h = dt/4.
TEST_P(SoftStepProgram, FallsShortByItsSubStep) {
  const BodyState fallen = last_state(engine(), named({body_of(BodyType::dynamic, {0, 10}, Circle{.5, {}})}), {}, 60);
  const double off = g * 1 * (dt / 4) / 2;
  EXPECT_NEAR(fallen.position.y - (10 - g / 2), -off, off / 100);
}

// As deep as the springs that it states bear the weights: 32.5 mm.
TEST_P(SoftStepProgram, LetsATowerOfTenSinkByItsSprings) {
  std::vector<Body> tower{body_of(BodyType::fixed, {}, HalfSpace{})};
  for (int i = 0; i < 10; ++i) tower.push_back(body_of(BodyType::dynamic, {0, i + .5}, Box{}));
  const BodyState top = last_state(engine(), named(tower), {}, 600);
  const Stepping stated = engine().stepping({}, dt);
  EXPECT_EQ(stated.contact_frequency, 30);
  const double sinks = tower_sinks(stated, g, std::vector<double>(10, 1), 10);
  EXPECT_NEAR(9.5 - top.position.y, sinks, sinks / 100);
}

// Restitution acts at the end of a step, on the closing speed at its start.
TEST_P(SoftStepProgram, ReboundsAtItsShareOfTheSpeedAtTheStepsStart) {
  const double e = .8;
  const Scene scene =
      named({body_of(BodyType::fixed, {}, HalfSpace{}, e), body_of(BodyType::dynamic, {0, 4.5}, Circle{.5, {}}, e)});
  const std::unique_ptr<Simulation> simulation = engine().build(scene, {});
  std::vector<BodyState> states(2);
  double before = 0;
  double after = 0;
  for (int i = 0; i < 90 && after <= 0; ++i) {
    before = after;
    simulation->step(dt);
    simulation->read(states);
    after = states[1].velocity.y;
  }
  EXPECT_NEAR(after, -e * before, e * -before / 100);
}

// The point that a disc of .5 m rolls on rises by r (1 - cos w dt) in a step, 4.4 mm at 8 rad/s; it is let down by
// about half of that, and no more than all.
TEST_P(SoftStepProgram, LetsARollingDiscSinkInAsItsPointsAreHeld) {
  Body disc = body_of(BodyType::dynamic, {0, .5}, Circle{.5, {}});
  disc.velocity = {4, 0};
  disc.angular_velocity = -8;
  const BodyState rolled = last_state(engine(), named({body_of(BodyType::fixed, {}, HalfSpace{}), disc}), {}, 120);
  ASSERT_TRUE(engine().stepping({}, dt).held_anchors);
  const double most = .5 * (1 - std::cos(8 * dt));
  EXPECT_LT(.5 - rolled.position.y, most);
  EXPECT_GT(.5 - rolled.position.y, .4 * most);
}

// At 1 m/s it comes 16.7 mm in a step, and 4.2 mm in a sub-step more.
TEST_P(SoftStepProgram, BrakesWhatWouldTouchWithinASubStepMore) {
  const auto after = [&](double gap) {
    Body disc = body_of(BodyType::dynamic, {0, .5 + gap}, Circle{.5, {}});
    disc.velocity = {0, -1};
    disc.gravity_scale = 0;
    return last_state(engine(), named({body_of(BodyType::fixed, {}, HalfSpace{}), disc}), {}, 1).velocity.y;
  };
  const Stepping stated = engine().stepping({}, dt);
  const double within = dt + stated.impact_lead * stated.h;
  EXPECT_GT(after(.9 * within), -.9);
  EXPECT_NEAR(after(1.01 * within), -1, 1e-6);
}

// Four links of 1 kg below each other, of which Box2D says that hinges are springs.
TEST_P(SoftStepProgram, SagsByTheSpringsOfItsJointsIfItStatesThem) {
  std::vector<Body> chain{body_of(BodyType::fixed, {}, HalfSpace{.offset = -10})};
  for (int i = 0; i < 4; ++i) chain.push_back(body_of(BodyType::dynamic, {0, -i - .5}, Box{}));
  for (Body& body : chain) body.layers = 0;
  Scene scene = named(std::move(chain));
  for (std::size_t i = 0; i < 4; ++i) {
    scene.joints.push_back(Revolute{.a = i, .b = i + 1, .anchor = {0, -static_cast<double>(i)}});
  }
  const double frequency = engine().stepping({}, dt).joint_frequency;
  EXPECT_EQ(frequency, GetParam() == "box2d3" ? 60 : 0);
  if (frequency == 0) return;
  const double sags = -sag_of(scene, frequency).back().shift.y;
  EXPECT_NEAR(-3.5 - last_state(engine(), scene, {}, 600).position.y, sags, sags / 100);
}

TEST_P(SoftStepProgram, KeepsSpringsBounded) { expect_bounded_spring(engine()); }

TEST_P(SoftStepProgram, FindsImpactsWithinItsStatedLag) { expect_impacts_within_the_stated_lag(engine()); }

TEST_P(SoftStepProgram, RestoresSpeedWithoutFriction) { expect_no_friction_of_restitution(engine()); }

// A disc slides down a smooth dome of 1 m. Found anew in a step, a normal is that of its start, to what gravity adds in
// it; kept until the disc has slid 5 cm on its circle of 1.5 m, it is up to 33 mrad off.
TEST_P(SoftStepProgram, KeepsNormalsUntilBodiesHaveMovedIfItRecyclesContacts) {
  if (GetParam() != "rapier") GTEST_SKIP() << "finds contacts anew in each step";
  Scene scene =
      named({body_of(BodyType::fixed, {}, Circle{1, {}}), body_of(BodyType::dynamic, {0, 1.5}, Circle{.5, {}})});
  for (Body& body : scene.bodies) body.shapes[0].surface.static_friction = body.shapes[0].surface.dynamic_friction = 0;
  scene.bodies[1].velocity = {.5, 0};
  const auto farthest_off = [&](const char* recycling) {
    const std::unique_ptr<Simulation> simulation = engine().build(scene, {{"recycling", recycling}});
    std::vector<BodyState> states(2);
    double off = 0;
    for (int i = 0; i < 30; ++i) {
      simulation->read(states);
      simulation->step(dt);
      std::vector<ContactState> contacts;
      simulation->read_contacts(contacts);
      for (const ContactState& contact : contacts) {
        const Vec to = states[contact.b].position - states[contact.a].position;
        off = std::max(off, std::abs(cross(contact.normal, to)) / length(to));
      }
    }
    return off;
  };
  EXPECT_LT(farthest_off("off"), 1e-3);
  EXPECT_GT(farthest_off("on"), .02);
  EXPECT_LT(farthest_off("on"), 1.001 * .05 / 1.5);
}

std::string folder_name(const testing::TestParamInfo<std::string>& engine) { return engine.param; }

INSTANTIATE_TEST_SUITE_P(Npm, SoftStepProgram, testing::Values("rapier", "box2d3"), folder_name);

}  // namespace
}  // namespace plumb::adapter_tests
