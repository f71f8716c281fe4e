#include "reports/run/statement.h"

#include <gmock/gmock.h>

#include <numbers>

#include "../fakes.h"
#include "reports/run/experiment.h"
#include "reports/run/selection.h"

namespace plumb::statement_test {
namespace {

using ::testing::HasSubstr;

constexpr double dt = 1.0 / 60;

TEST(Statement, SaysInMillimetresHowFarContactsMayRestFromTouching) {
  Stepping stepping;
  stepping.impact_lag = 0;
  EXPECT_EQ(statement(stepping), "") << "what is not stated is not said";
  stepping.skin = 0.015;
  stepping.slop = 0.005;
  stepping.iterations = 8;
  stepping.position_iterations = 3;
  stepping.epsilon = 6e-8;
  EXPECT_EQ(statement(stepping),
            "bodies may rest 15 mm apart; leaves overlaps of up to 5 mm alone; 8 iterations of velocities, 3 of "
            "positions; single precision");
}

TEST(Statement, SaysThatContactsAreSpringsAndVelocitiesDifferences) {
  Stepping stepping;
  stepping.impact_lag = 0;
  stepping.h = 0.004;
  stepping.impact_lead = 1;
  stepping.contact_frequency = 30;
  stepping.fixed_contact_frequency = stepping.joint_frequency = 60;
  stepping.held_anchors = stepping.tangent_rotation = true;
  stepping.differenced_velocities = true;
  EXPECT_EQ(statement(stepping),
            "brakes an approach up to 4 ms early; contacts are springs of 30 Hz, 60 Hz on what does not move, and "
            "overlap by their load; holds contact "
            "points on both bodies for a step, which lets rolling bodies sink in; turns by atan(w h) in a sub-step; "
            "joints are springs of 60 Hz and open "
            "by their load; keeps velocities as differences of positions");
}

TEST(Statement, SaysHowFarJointsGiveWay) {
  Stepping stepping;
  stepping.impact_lag = 0;
  stepping.joint_slop = 0.005;
  stepping.angular_slop = std::numbers::pi / 90;
  EXPECT_EQ(statement(stepping), "joints may be open by 5 mm; a hinge may rest 2 degrees past its limit");
}

TEST(MoreIterations, AreThoseThatAnEngineStates) {
  const auto box2d = with_more_iterations(parse_engine("box2d"), dt);
  ASSERT_TRUE(box2d.has_value());
  EXPECT_EQ(box2d->before, "8/3");
  EXPECT_EQ(box2d->after, "256/96");
  EXPECT_EQ(box2d->config.engine->stepping(box2d->config.settings, dt).iterations, 256);
  const auto few = with_more_iterations(parse_engine("chipmunk:iterations=1"), dt);
  ASSERT_TRUE(few.has_value());
  EXPECT_EQ(few->before + " " + few->after, "1 32");
  EXPECT_EQ(few->config.settings.at("slop"), parse_engine("chipmunk").settings.at("slop"));
}

TEST(MoreIterations, AreNoneForAMethodThatStatesNone) {
  EXPECT_FALSE(with_more_iterations(parse_engine("impulse"), dt).has_value());
}

struct OwnedScene {
  Scene owned;
};

// Symplectic Euler in a scene of its own.
class Altered : private OwnedScene, public fakes::Stepper {
 public:
  explicit Altered(const Scene& scene) : OwnedScene{scene}, Stepper(owned, Fault::none) {}
};

// An engine that lets a body fall at a share of gravity: at half of it, unless it has 128 iterations.
Engine falling_by_iterations(double at_many) {
  Engine engine = fakes::engine("iterative");
  engine.options = {{.key = "iterations", .value = "4", .about = "iterations", .min = 1, .max = 1000, .whole = true}};
  engine.stepping = [](const Settings& settings, double step) {
    return Stepping{
        .dt = step, .h = step, .drift = 0.5, .iterations = std::stoi(settings.at("iterations")), .epsilon = 1e-16};
  };
  engine.build = [at_many](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
    Scene altered = scene;
    const double share = settings.at("iterations") == "128" ? at_many : 0.5;
    altered.gravity = {share * scene.gravity.x, share * scene.gravity.y};
    return std::make_unique<Altered>(altered);
  };
  return engine;
}

RunRecord thrown_by(const Engine& engine, bool explain) {
  const Scenario scenario = fakes::throwing();
  const Engine closed_form = fakes::free_flight();
  Plan plan{.cases = {fakes::case_of(scenario, &closed_form)}, .timed = false, .explain = explain};
  plan.configs = {{&engine, complete(engine, {})}};
  return run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {}).runs.at(1);
}

TEST(MoreIterations, AreSaidToCureWhatTheyCure) {
  const RunRecord run = thrown_by(falling_by_iterations(1), true);
  EXPECT_EQ(run.verdict, Verdict::wrong) << "at the iterations it was asked for";
  EXPECT_EQ(run.reason, "not converged at 4: coarse with 128 iterations");
}

TEST(MoreIterations, AreNotMentionedWhereTheyCureNothing) {
  const RunRecord run = thrown_by(falling_by_iterations(0.6), true);
  EXPECT_EQ(run.verdict, Verdict::wrong);
  EXPECT_EQ(run.reason, "");
}

TEST(MoreIterations, AreTriedOnlyWhereAPlanAsksToExplain) {
  EXPECT_EQ(thrown_by(falling_by_iterations(1), false).reason, "");
}

TEST(MoreIterations, CureBox2DOfARodThatJams) {
  Plan plan{
      .cases = parse_cases("painleve-rod:mu=2"), .configs = {parse_engine("box2d")}, .timed = false, .explain = true};
  const Report report = run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {});
  ASSERT_EQ(report.runs.back().verdict, Verdict::wrong);
  EXPECT_THAT(report.runs.back().reason, HasSubstr("not converged at 8/3: coarse with 256/96 iterations"));
}

}  // namespace
}  // namespace plumb::statement_test
