#include "reference/reduced_model.h"

#include <gmock/gmock.h>

#include <optional>

#include "reports/judge/observe.h"
#include "reports/judge/verdict.h"
#include "reports/run/selection.h"
#include "scenarios/parts.h"

namespace plumb::reduced_model_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

Scene spinning_disc() {
  Scene made;
  made.bodies = {level_ground(surface(0.5, 0.2)), disc("disc", {0, 1}, 0.5, surface(0.5, 0.2))};
  made.bodies[1].angular_velocity = 2;
  made.bodies[1].shapes[0].surface.static_friction = 0.8;
  return made;
}

const Surface& of_disc(const Scene& scene) { return scene.bodies[1].shapes[0].surface; }

Scene with(const std::string& option, const std::string& value) {
  Settings settings{{"rotation", "on"}, {"friction", "full"}, {"restitution", "on"}};
  settings[option] = value;
  return reduced(spinning_disc(), settings);
}

TEST(Reduced, LeavesASceneAsItIsByDefault) {
  for (const Option& option : reductions()) {
    const Scene same = with(option.key, option.value);
    EXPECT_EQ(same.bodies[1].angular_velocity, 2);
    EXPECT_FALSE(same.bodies[1].fixed_rotation);
    EXPECT_EQ(of_disc(same).static_friction, 0.8);
    EXPECT_EQ(of_disc(same).restitution, 0.2);
  }
}

TEST(Reduced, RemovesWhatTheOptionSaysAndNothingElse) {
  EXPECT_TRUE(with("rotation", "off").bodies[1].fixed_rotation);
  EXPECT_EQ(with("rotation", "off").bodies[1].angular_velocity, 0);
  EXPECT_FALSE(with("rotation", "off").bodies[0].fixed_rotation);
  EXPECT_EQ(of_disc(with("rotation", "off")).static_friction, 0.8);
  EXPECT_EQ(of_disc(with("friction", "dynamic")).static_friction, 0.5);
  EXPECT_EQ(of_disc(with("friction", "dynamic")).dynamic_friction, 0.5);
  EXPECT_EQ(of_disc(with("friction", "off")).static_friction, 0);
  EXPECT_EQ(of_disc(with("friction", "off")).dynamic_friction, 0);
  EXPECT_EQ(of_disc(with("friction", "off")).restitution, 0.2);
  EXPECT_EQ(of_disc(with("restitution", "off")).restitution, 0);
  EXPECT_EQ(of_disc(with("restitution", "off")).dynamic_friction, 0.5);
}

std::vector<std::string> left_out_of(const Scene& scene) {
  std::vector<std::string> options;
  for (const Choice& choice : redundant_features(scene)) {
    EXPECT_NE(choice.reason, "") << choice.option;
    options.push_back(choice.option);
  }
  return options;
}

Scene on_the_ground(const Surface& made_of) {
  Scene scene;
  scene.bodies = {level_ground(made_of), disc("disc", {0, 1}, 0.5, made_of)};
  return scene;
}

TEST(RedundantFeatures, AreNoneWhereARoughBouncingBodyMeetsAnother) {
  EXPECT_THAT(left_out_of(on_the_ground(surface(0.5, 0.5))), IsEmpty());
}

TEST(RedundantFeatures, AreThoseWhoseCoefficientIsZeroEverywhere) {
  EXPECT_THAT(left_out_of(on_the_ground(surface(0.5, 0))), ElementsAre("restitution"));
  EXPECT_THAT(left_out_of(on_the_ground(surface(0, 0.5))), UnorderedElementsAre("friction", "rotation"));
}

TEST(RedundantFeatures, IncludeRotationOnlyWhereNothingRotates) {
  Scene scene = on_the_ground(surface(0, 0.5));
  scene.bodies[1].angular_velocity = 1;
  EXPECT_THAT(left_out_of(scene), ElementsAre("friction"));
  scene = on_the_ground(surface(0, 0.5));
  scene.bodies[1].shapes[0].geometry = Box{};
  EXPECT_THAT(left_out_of(scene), ElementsAre("friction"));
  scene = on_the_ground(surface(0, 0.5));
  std::get<Circle>(scene.bodies[1].shapes[0].geometry).center = {0.1, 0};
  EXPECT_THAT(left_out_of(scene), ElementsAre("friction"));
  scene = on_the_ground(surface(0, 0.5));
  scene.forces.push_back(Constant{1, {}, 1});
  EXPECT_THAT(left_out_of(scene), ElementsAre("friction"));
  scene.forces = {Spring{{}, 1, {}, {0.1, 0}, 1, 0, 0}};
  EXPECT_THAT(left_out_of(scene), ElementsAre("friction"));
}

TEST(RedundantFeatures, IncludeContactsOfABodyThatFliesAlone) {
  Scene scene = on_the_ground(surface(0.5, 0.5));
  scene.bodies[1].position.y = 50;
  EXPECT_THAT(left_out_of(scene), UnorderedElementsAre("contacts", "continuous", "rotation"));
}

// Checked on every scenario. Where bodies touch, the whole model may rotate a frictionless disc a little, since lever
// arms are those of the start of a step. Leaving rotation out then changes the run for the better; no verdict may be
// worse.
TEST(RedundantFeatures, MakeNoScenarioWorseWhenLeftOut) {
  const EngineConfig whole = parse_engine("impulse");
  const EngineConfig chosen = parse_engine("impulse:auto");
  for (const Case& one : default_cases(true)) {
    const std::vector<Choice> choices = redundant_features(*one.scene);
    if (one.scene->bodies.size() > 200 || choices.empty()) continue;
    const Outcome a = run(*one.scene, whole, 1.0 / 60);
    const Outcome b = run(*one.scene, chosen, 1.0 / 60);
    ASSERT_EQ(b.status, a.status) << one.scenario->name;
    if (a.status != Status::ok) continue;
    std::optional<Truth> truth;
    if (one.closed_form != nullptr && one.closed_form->unsupported(*one.scene, {}).empty()) {
      truth.emplace(*one.closed_form, *one.scene);
    }
    const auto verdict_of = [&](const Outcome& outcome) {
      return judge(*one.scene, one.scenario->expectations(one.parameters), *outcome.trace,
                   whole.engine->stepping(whole.settings, 1.0 / 60), truth ? &*truth : nullptr)
          .verdict;
    };
    EXPECT_EQ(verdict_of(b), verdict_of(a)) << one.scenario->name << " " << one.variant;
    if (choices.front().option != "contacts") continue;
    const auto last = a.trace->states(a.trace->size() - 1);
    const auto other = b.trace->states(b.trace->size() - 1);
    for (std::size_t i = 0; i < last.size(); ++i) {
      EXPECT_EQ(last[i].position, other[i].position) << one.scenario->name << " " << one.variant;
      EXPECT_EQ(last[i].angle, other[i].angle) << one.scenario->name << " " << one.variant;
    }
  }
}

// Two discs of radius 1/2 for a second without gravity.
Scene two(Vec apart, Vec closing) {
  Scene scene;
  scene.gravity = {};
  scene.bodies = {disc("a", {0, 0}, 0.5, surface(0, 1)), disc("b", apart, 0.5, surface(0, 1))};
  scene.bodies[1].velocity = closing;
  return scene;
}

bool none_meet(const Scene& scene) { return !why_none_meet(scene).empty(); }

TEST(WhyNoneMeet, DistinguishesBodiesThatPassFromBodiesThatMeet) {
  EXPECT_TRUE(none_meet(two({3, 0}, {})));
  EXPECT_TRUE(none_meet(two({3, 0}, {-1.9, 0})));
  EXPECT_FALSE(none_meet(two({3, 0}, {-2.1, 0})));
  EXPECT_TRUE(none_meet(two({3, 1.1}, {-6, 0})));
  EXPECT_FALSE(none_meet(two({3, 0.9}, {-6, 0})));
}

TEST(WhyNoneMeet, LooksNoFartherThanTheEndOfTheScene) {
  Scene scene = two({3, 0}, {-1, 0});
  EXPECT_TRUE(none_meet(scene));
  scene.duration = 3;
  EXPECT_FALSE(none_meet(scene));
}

TEST(WhyNoneMeet, SeesThatBodiesFallingTogetherStayApart) {
  Scene scene = two({1.1, 0}, {});
  scene.gravity = {0, -10};
  EXPECT_TRUE(none_meet(scene));
  scene.bodies[1].gravity_scale = 0.5;
  scene.bodies[1].position = {0, -1.1};
  EXPECT_FALSE(none_meet(scene));
}

// 5 m in a second.
TEST(WhyNoneMeet, SeesWhetherAFallReachesTheGroundInTime) {
  Scene scene;
  scene.bodies = {level_ground(surface(0, 0)), disc("disc", {0, 5.6}, 0.5, surface(0, 0))};
  EXPECT_TRUE(none_meet(scene));
  scene.bodies[1].position.y = 5.4;
  EXPECT_FALSE(none_meet(scene));
  scene.bodies[1].position.y = 5.6;
  scene.forces.push_back(Constant{1, {0, -1}, 0});
  EXPECT_FALSE(none_meet(scene));
}

TEST(WhyNoneMeet, ClaimsNothingUnderDampingOrSprings) {
  Scene scene = two({30, 0}, {});
  EXPECT_TRUE(none_meet(scene));
  scene.bodies[1].linear_damping = 1;
  EXPECT_FALSE(none_meet(scene));
  scene.bodies[1].linear_damping = 0;
  scene.forces.push_back(Spring{0, 1, {}, {}, 1, 0, 0});
  EXPECT_FALSE(none_meet(scene));
}

TEST(WhyNoneMeet, SeesThatLayersJointsOrMissingShapesKeepBodiesApart) {
  Scene scene = two({0, 0}, {});
  EXPECT_FALSE(none_meet(scene));
  scene.joints.push_back(Revolute{0, 1, {}});
  EXPECT_TRUE(none_meet(scene));
  scene.joints.clear();
  scene.bodies[0].layers = 1;
  scene.bodies[1].layers = 2;
  EXPECT_TRUE(none_meet(scene));
  scene.bodies[1].layers = 3;
  EXPECT_FALSE(none_meet(scene));
  scene.bodies[1].shapes.clear();
  EXPECT_TRUE(none_meet(scene));
}

TEST(WhyNoneMeet, CountsTheCornersOfARotatingBody) {
  Scene scene = two({3, 0}, {});
  scene.bodies[1].shapes[0].geometry = Box{.size = {2, 2}};  // 1 m to its sides, 1.41 m to its corners
  scene.bodies[1].position = {1.6, 0};
  EXPECT_FALSE(none_meet(scene));
  scene.bodies[1].position = {2, 0};
  EXPECT_TRUE(none_meet(scene));
}

TEST(WhyNoneMeet, IsRightForEveryScenarioWhereItClaimsSo) {
  for (const Case& one : default_cases(true)) {
    if (!none_meet(*one.scene)) continue;
    const EngineConfig engine = parse_engine("impulse");
    const Outcome outcome = run(*one.scene, engine, 1.0 / 60);
    ASSERT_EQ(outcome.status, Status::ok) << one.scenario->name;
    for (std::size_t moment = 0; moment < outcome.trace->size(); ++moment) {
      for (const ContactState& contact : outcome.trace->contacts(moment)) {
        EXPECT_EQ(contact.normal_impulse, 0) << one.scenario->name << " " << one.variant;
      }
    }
  }
}

}  // namespace
}  // namespace plumb::reduced_model_test
