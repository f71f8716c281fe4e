#include "reference/needs.h"

#include <gmock/gmock.h>

#include "reports/judge/observe.h"
#include "reports/judge/verdict.h"
#include "reports/run/selection.h"
#include "scenarios/parts.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<std::string> left_out_of(const Scene& scene) {
  std::vector<std::string> options;
  for (const Choice& choice : needless(scene)) {
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

TEST(Needless, IsNothingWhereARoughBouncingBodyMeetsAnother) {
  EXPECT_THAT(left_out_of(on_the_ground(surface(0.5, 0.5))), IsEmpty());
}

TEST(Needless, IsWhatNoCoefficientAsksFor) {
  EXPECT_THAT(left_out_of(on_the_ground(surface(0.5, 0))), ElementsAre("restitution"));
  EXPECT_THAT(left_out_of(on_the_ground(surface(0, 0.5))), UnorderedElementsAre("friction", "rotation"));
}

TEST(Needless, IsTurningOnlyWhereNothingTurns) {
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

TEST(Needless, IsEveryContactOfWhatFliesAlone) {
  Scene scene = on_the_ground(surface(0.5, 0.5));
  scene.bodies[1].position.y = 50;
  EXPECT_THAT(left_out_of(scene), UnorderedElementsAre("contacts", "continuous", "rotation"));
}

// Its promise, on every scenario there is. Where bodies touch, the whole model may turn a smooth disc a little, since
// arms are those of a step's start: to leave that out changes the run, for the better; nothing may be judged worse.
TEST(Needless, MakesNoScenarioWorse) {
  const EngineConfig whole = parse_engine("impulse");
  const EngineConfig chosen = parse_engine("impulse:auto");
  for (const Case& one : default_cases(true)) {
    const std::vector<Choice> choices = needless(*one.scene);
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

}  // namespace
}  // namespace plumb
