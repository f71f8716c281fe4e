#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "relation_runs.h"
#include "scenarios/parts.h"

namespace plumb::relation_tests {
namespace {

Body& body_of(Scene& scene, const std::string& name) {
  return *std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const Body& one) { return one.name == name; });
}

// A mistake that shows only in one relation's image, with what an engine could know of it.
struct Mistake {
  const char* relation;
  Scene scene;
  std::function<void(Scene&)> mistake;
};

// Each is far more than round-off, and little beside the motion.
std::vector<Mistake> mistakes() {
  const Scene flying = flying_rod();
  return {
      {"shift", box_and_disc(),
       [](Scene& scene) { body_of(scene, "disc").velocity.x += 1e-3 * body_of(scene, "disc").position.x; }},
      {"turn", box_and_disc(), [](Scene& scene) { scene.gravity.x *= 1.001; }},
      {"mirror", box_and_disc(), [](Scene& scene) { body_of(scene, "box").velocity.x += 1e-3; }},
      {"mass", box_and_disc(),
       [](Scene& scene) {
         for (Body& body : scene.bodies)
           for (Shape& shape : body.shapes) shape.surface.dynamic_friction -= 1e-3 * shape.surface.density;
       }},
      {"order", box_and_disc(),
       [](Scene& scene) {
         if (scene.bodies.front().type == BodyType::dynamic) scene.bodies.front().velocity.x += 5e-3;
       }},
      {"stranger", box_and_disc(),
       [](Scene& scene) { scene.gravity.y *= 1 + 1e-9 * static_cast<double>(scene.bodies.size()); }},
      {"two_worlds", box_and_disc(),
       [](Scene& scene) { scene.gravity.y *= 1 + 1e-3 * static_cast<double>(scene.bodies.size()); }},
      {"galilei", flying, [](Scene& scene) { scene.bodies[0].angular_velocity += 0.1 * scene.bodies[0].velocity.x; }},
      {"units", box_and_disc(), [](Scene& scene) { scene.gravity.y -= 0.02 * body_of(scene, "disc").position.y; }},
      {"time", flying, [](Scene& scene) { scene.bodies[0].linear_damping = 0.1; }}};
}

TEST(Relations, AreKeptByOurEngine) {
  for (const Mistake& one : mistakes()) {
    const RelationCheck check = ours(one.relation, one.scene);
    EXPECT_EQ(check.why_not, "") << one.relation;
    EXPECT_EQ(check.check.status, CheckStatus::held)
        << one.relation << " " << check.check.value << " > " << check.check.tolerance << ": " << check.check.detail;
    EXPECT_TRUE(is_evidence(check.check)) << one.relation;
    EXPECT_LT(check.share, 1e-2) << one.relation;
  }
}

TEST(Relations, AreBrokenByAnEngineThatKnowsTooMuch) {
  for (const Mistake& one : mistakes()) {
    const RelationCheck check = mistaken(one.relation, one.scene, one.mistake);
    EXPECT_EQ(check.check.status, CheckStatus::broken)
        << one.relation << " " << check.check.value << " <= " << check.check.tolerance << ": " << check.check.detail;
  }
}

// One that turns to another law at short steps converges to nothing that it states.
TEST(Relations, HalvesAreBrokenByAnErrorThatDoesNotShrink) {
  EXPECT_EQ(ours("halves", flying_rod()).check.status, CheckStatus::held);
  const auto gliding = [](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
    struct Glider : fakes::Stepper {
      using Stepper::Stepper;
      void step(double dt) override { Stepper::step(dt < 0.01 ? 0.9 * dt : dt); }
    };
    return std::make_unique<Glider>(scene, fakes::Stepper::Fault::none);
  };
  Engine wrong = fakes::engine("gliding");
  const Scene scene = fakes::thrown_box();
  const RelationCheck right = checked("halves", scene, {&wrong, {}});
  EXPECT_EQ(right.check.status, CheckStatus::held) << right.check.value << " > " << right.check.tolerance;
  wrong.build = gliding;
  EXPECT_EQ(checked("halves", scene, {&wrong, {}}).check.status, CheckStatus::broken);
}

// Twenty sizes of a small planet away it fell into the sun.
TEST(Relations, PutTheStrangerFarFromWhatAttractsAllBodies) {
  Body planet = box("planet", {-1.3072453387953409, -3.494491468611399}, {0.14, 0.12617}, surface(0, 0));
  planet.velocity = {2.721089889368461, -0.93653250270458};
  const Scene orbit{.name = "orbit",
                    .gravity = {},
                    .duration = 1.9,
                    .bodies = {{.name = "sun", .type = BodyType::fixed}, planet},
                    .forces = {Attraction{.from = 0, .strength = 30, .exponent = 2}}};
  const RelationCheck check = ours("stranger", orbit);
  EXPECT_EQ(check.check.status, CheckStatus::held) << check.check.value << " " << check.why_not;
}

TEST(Relations, SayWhyTheySayNothing) {
  Scene damped = flying_rod();
  damped.bodies[0].linear_damping = 0.1;
  EXPECT_EQ(ours("galilei", damped).why_not, "air that stands still damps velocities");
  EXPECT_EQ(ours("time", damped).why_not, "damping has an arrow of time");
  EXPECT_EQ(ours("time", box_and_disc()).why_not, "friction has an arrow of time");
  // 5 m in 1 s, before which the scene ends, but not the run.
  Scene lands{.name = "lands",
              .duration = 0.99,
              .bodies = {level_ground(surface(0, 0)), disc("disc", {0, 5.45}, 0.5, surface(0, 0))}};
  EXPECT_EQ(ours("time", lands).why_not, "inelastic impacts have an arrow of time");
  lands.bodies[1].position.y = 5.8;
  EXPECT_EQ(ours("time", lands).why_not, "");
  Scene held = flying_rod();
  held.forces.push_back(Spring{.b = 0, .stiffness = 1, .length = 1});
  EXPECT_EQ(ours("galilei", held).why_not, "a spring ends at a point of the world, which cannot move");
  Scene pulled = flying_rod();
  pulled.forces.push_back(Attraction{.from = 0, .strength = 1, .mutual = true});
  EXPECT_EQ(ours("stranger", pulled).why_not, "every body pulls at the centre of a mutual attraction");
  EXPECT_EQ(ours("two_worlds", pulled).why_not, "an attraction reaches the second world");
}

TEST(Relations, AreBrokenByAnImageThatFails) {
  Engine failing = fakes::engine("failing");
  failing.build = [](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
    const bool image = scene.bodies.front().position.x != 1;
    return std::make_unique<fakes::Stepper>(scene, image ? fakes::Stepper::Fault::nan : fakes::Stepper::Fault::none);
  };
  const RelationCheck check = checked("shift", fakes::thrown_box(), {&failing, {}});
  EXPECT_EQ(check.check.status, CheckStatus::broken);
  EXPECT_TRUE(std::isinf(check.check.ratio));
  EXPECT_NE(check.check.detail.find("diverged"), std::string::npos);
}

TEST(Relations, AreAllThere) {
  std::vector<std::string> names;
  for (const MetamorphicRelation* one : Catalog<MetamorphicRelation>::all()) names.push_back(one->name);
  EXPECT_EQ(names, (std::vector<std::string>{"galilei", "halves", "mass", "mirror", "order", "shift", "stranger",
                                             "time", "turn", "two_worlds", "units"}));
  EXPECT_THROW(images_of("sift", flying_rod(), Trace(2), 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace plumb::relation_tests
