#include "reports/run/experiment.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <numbers>

#include "../fakes.h"
#include "reports/run/selection.h"
#include "reports/writers/json.h"

namespace plumb::experiment_test {
namespace {

using fakes::Stepper;
using ::testing::HasSubstr;

class Throwing : public ::testing::Test {
 protected:
  Report run_engines(const std::vector<const Engine*>& engines) {
    Plan plan{.cases = {fakes::case_of(scenario_, &closed_form_)}};
    for (const Engine* engine : engines) plan.configs.push_back({engine, {}});
    return run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {});
  }

  Scenario scenario_ = fakes::throwing();
  Engine closed_form_ = fakes::free_flight();
  Engine ours_ = fakes::engine("ours");
  Engine lost_ = fakes::engine("lost", Stepper::Fault::nan);
  Engine rival_ = fakes::engine("rival");
};

TEST_F(Throwing, SymplecticEulerIsCoarseWithinItsOwnDrift) {
  const Report report = run_engines({&ours_});
  ASSERT_EQ(report.runs.size(), 2u);
  EXPECT_TRUE(report.runs[0].exact);
  const RunRecord& run = report.runs[1];
  EXPECT_EQ(run.verdict, Verdict::coarse) << "off by g t dt/2 of a rise by v^2/(2g): some 3 %";
  ASSERT_EQ(run.truth.size(), 2u);
  EXPECT_NEAR(run.truth[0].error, 10 * 2 / 60.0 / 2, 1e-12);
  EXPECT_NEAR(run.metrics.at("truth_error_max").value, 10 * 2 / 60.0 / 2, 1e-12);
}

TEST_F(Throwing, AnEngineThatWronglyClaimsToBeExactIsWrong) {
  ours_.stepping = [](const Settings&, double dt) { return Stepping{.dt = dt, .h = dt, .epsilon = 1e-16}; };
  EXPECT_EQ(run_engines({&ours_}).runs[1].verdict, Verdict::wrong);
}

TEST_F(Throwing, OtherEnginesRunIfOneDiverges) {
  const Report report = run_engines({&ours_, &lost_, &rival_});
  ASSERT_EQ(report.runs.size(), 4u);
  EXPECT_EQ(report.runs[2].status, Status::failed);
  EXPECT_EQ(report.runs[2].verdict, Verdict::failed);
  EXPECT_THAT(report.runs[2].reason, ::testing::StartsWith("diverged at t = 1 s"));
  EXPECT_EQ(report.runs[3].verdict, Verdict::coarse);
  EXPECT_EQ(report.timings.size(), 2u) << "a failed run has no timing";
}

TEST_F(Throwing, IsIdenticalExceptForTimes) {
  const auto text = [&] {
    auto json = to_json(run_engines({&ours_, &lost_, &rival_}));
    json.erase("timings");
    return json.dump();
  };
  EXPECT_EQ(text(), text());
}

TEST(RunExperiment, IsIdenticalForAnyNumberOfJobs) {
  const auto text = [](int jobs) {
    const Plan plan{.cases = default_cases(false), .configs = default_engines(), .jobs = jobs};
    auto json = to_json(run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {}));
    json.erase("timings");
    return json.dump();
  };
  const std::string alone = text(1);
  EXPECT_EQ(alone, text(2));
  EXPECT_EQ(alone, text(5));
}

TEST(RunExperiment, JudgesByAConvergedAnswerThatSaysWhereItEnds) {
  if (Catalog<Engine>::find("chipmunk") == nullptr) GTEST_SKIP() << "built without Chipmunk";
  const Plan plan{.cases = parse_cases("double-pendulum:wild"),
                  .configs = {parse_engine("impulse")},
                  .refine = 100'000,
                  .timed = false};
  const Report report = run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {});
  ASSERT_EQ(report.runs.size(), 2u);
  EXPECT_THAT(report.runs[0].reason, ::testing::HasSubstr(", until "));
  EXPECT_LT(report.runs[0].metrics.at("truth_until").value, 5);
  EXPECT_FALSE(report.runs[1].truth.empty());
  EXPECT_EQ(report.runs[1].verdict, Verdict::right);
}

TEST(RunExperiment, ChecksRelationsOnlyIfAskedTo) {
  Plan plan{.cases = parse_cases("bounce:e=0.5"), .configs = {parse_engine("impulse")}, .timed = false};
  const auto relations_in = [&] {
    const Report report = run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {});
    std::vector<std::string> names;
    for (const InvariantCheck& check : report.runs.back().invariants) {
      if (!check.name.starts_with("relation_")) continue;
      names.push_back(check.name);
      EXPECT_EQ(check.status, CheckStatus::held) << check.name;
      EXPECT_FALSE(check.detail.empty());
      EXPECT_TRUE(report.runs.back().metrics.contains(check.name));
    }
    return names;
  };
  EXPECT_TRUE(relations_in().empty());
  plan.relations = true;
  // All but time: the disc loses energy.
  EXPECT_EQ(relations_in().size(), 10U);
}

TEST(RunExperiment, HasNoTruthWithoutABudgetForIt) {
  const Plan plan{.cases = parse_cases("double-pendulum:wild"), .configs = {parse_engine("impulse")}, .timed = false};
  const Report report = run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {});
  ASSERT_EQ(report.runs.size(), 1u);
  EXPECT_TRUE(report.runs[0].truth.empty());
}

TEST_F(Throwing, ExplainsItsNames) {
  const Report report = run_engines({&ours_});
  ASSERT_EQ(report.scenarios.size(), 1u);
  EXPECT_EQ(report.scenarios[0].question, "Does a thrown box fly as Galileo says?");
  ASSERT_EQ(report.engines.size(), 2u);
  EXPECT_EQ(report.engines[0].name, "ours");
  EXPECT_TRUE(report.engines[1].exact);
  EXPECT_FALSE(report.metrics.empty());
}

TEST_F(Throwing, HasTheShareOfTimeOutsideStep) {
  const double share = run_engines({&ours_}).clock.at("outside_step");
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1);
}

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
}  // namespace plumb::experiment_test
