#include "reports/gate/bounds.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "../fakes.h"
#include "reports/gate/result.h"

namespace plumb::bounds_test {
namespace {

constexpr auto silent = [](const std::string&, std::size_t, std::size_t) {};

// A thrown box. Gravity and start can be changed a little.
struct Thrown {
  Scenario scenario = fakes::throwing();
  Engine free_flight = fakes::free_flight();
  Engine engine = fakes::engine("ours");

  Plan plan(double gravity = 1, double moved = 0) const {
    Case thrown_case = fakes::case_of(scenario, &free_flight);
    Scene scene = *thrown_case.scene;
    scene.gravity.y *= gravity;
    scene.bodies[0].position.y += moved;
    thrown_case.scene = std::make_shared<const Scene>(scene);
    return {.cases = {thrown_case}, .configs = {{&engine, {}}}, .timed = false};
  }
  static Baseline on(const char* platform, const Plan& plan) {
    Report report = run_experiment(plan, silent);
    report.environment["libm"] = platform;
    return baseline_of(report);
  }
  Baseline accepted() const {
    Baseline baseline = on("one", plan());
    find_bounds(plan(), baseline, silent);
    return baseline;
  }
};

TEST(Bounds, AreSetForEveryNumberAndNarrowIfErrorsDoNotGrow) {
  const Thrown thrown;
  const Baseline baseline = thrown.accepted();
  ASSERT_EQ(baseline.runs.size(), 2u) << "the engine and the closed form";
  for (const auto& [key, run] : baseline.runs) {
    EXPECT_FALSE(run.numbers.empty()) << key.text();
    for (const auto& [name, number] : run.numbers) {
      ASSERT_TRUE(number.bound) << name;
      EXPECT_LT(*number.bound, 1e-6) << key.text() << ": " << name;
      EXPECT_FALSE(number.unstable) << name;
    }
  }
  const BaselineRun& ours = baseline.runs.at({"throw", "as it is", "ours", ""});
  EXPECT_EQ(ours.perturbed_verdicts, std::set<Verdict>{ours.verdict});
}

TEST(Bounds, AllowRoundingAndNothingMore) {
  const Thrown thrown;
  const Baseline before = thrown.accepted();
  EXPECT_TRUE(compare(before, Thrown::on("another", thrown.plan(1, 1e-13))).passed());
  const GateResult weaker = compare(before, Thrown::on("another", thrown.plan(0.999)));
  EXPECT_EQ(caught_by(weaker, {"throw", "as it is", "ours", ""}), Rule::bound);
}

TEST(Bounds, AreTheSameForAnyNumberOfJobs) {
  const Thrown thrown;
  Baseline one = thrown.accepted();
  Baseline three = one;
  for (auto& [key, run] : three.runs) {
    for (auto& [name, number] : run.numbers) number.bound.reset();
  }
  Plan plan = thrown.plan();
  plan.jobs = 3;
  find_bounds(plan, three, silent);
  for (const auto& [key, run] : one.runs) EXPECT_EQ(run.numbers, three.runs.at(key).numbers) << key.text();
}

// Moves left or right depending on the last bits of its starting position.
class OnAnEdge : public Simulation {
 public:
  explicit OnAnEdge(const Scene& scene) : states_(initial_states(scene)), side_(states_[0].position.x > 1 ? 1 : -1) {}
  void step(double dt) override { states_[0].position.x += side_ * dt; }
  void read(std::span<BodyState> out) const override { out[0] = states_[0]; }

 private:
  std::vector<BodyState> states_;
  double side_;
};

TEST(Bounds, AreWideIfPerturbedRunsDiverge) {
  Thrown thrown;
  thrown.engine.build = [](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
    return std::make_unique<OnAnEdge>(scene);
  };
  const Baseline baseline = thrown.accepted();
  const BaselineRun& run = baseline.runs.at({"throw", "as it is", "ours", ""});
  EXPECT_GT(*run.numbers.at("truth_error_end").bound, 0.1);
}

constexpr double single = std::numeric_limits<float>::epsilon() / 2;

Stepping steps_of(double dt, double epsilon) { return {.dt = dt, .h = dt, .drift = 0.5, .epsilon = epsilon}; }

// m, the error of y of a falling body if each sum is rounded to single precision.
double rounded_off(double dt, std::size_t steps) {
  double y = 2, v = 8;
  auto y_single = static_cast<float>(y), v_single = static_cast<float>(v);
  for (std::size_t i = 0; i < steps; ++i) {
    v -= 10 * dt;
    y += dt * v;
    v_single -= static_cast<float>(10 * dt);
    y_single += static_cast<float>(dt) * v_single;
  }
  return std::abs(static_cast<double>(y_single) - y);
}

TEST(RoundingOfARun, ExplainsTheErrorOfSinglePrecision) {
  const Scene scene = fakes::thrown_box();
  for (const double dt : {1.0 / 60, 1.0 / 100, 1.0 / 240, 1.0 / 1000}) {
    const Trace trace = fakes::flight_of(scene, dt);
    const Rounding rounding(scene, trace, steps_of(dt, single));
    const double off = rounded_off(dt, trace.size() - 1);
    EXPECT_LT(off, 10 * rounding.of("m")) << dt;
    EXPECT_GT(off, 0.0001 * rounding.of("m")) << dt;
  }
}

TEST(RoundingOfARun, GrowsAsARandomWalk) {
  const Scene scene = fakes::thrown_box();
  const auto of = [&](double dt) { return Rounding(scene, fakes::flight_of(scene, dt), steps_of(dt, single)).of("m"); };
  EXPECT_NEAR(of(1.0 / 1600) / of(1.0 / 100), 4, 0.1);
}

TEST(RoundingOfARun, KnowsTheUnitsOfAllNumbers) {
  const Scene scene = fakes::thrown_box();
  const Rounding rounding(scene, fakes::flight_of(scene, 0.01), steps_of(0.01, single));
  for (const char* unit : {"m", "m/s", "rad", "rad/s", "J", "1", "N", "N s", "N m", "kg m/s", "kg m^2/s"}) {
    EXPECT_GT(rounding.of(unit), 0) << unit;
    EXPECT_TRUE(std::isfinite(rounding.of(unit))) << unit;
  }
  EXPECT_EQ(rounding.of("bananas"), 0);
}

TEST(RoundingOfARun, AssumesThatClosedFormsAreEvaluatedInDouble) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.01);
  EXPECT_EQ(Rounding(scene, trace, steps_of(0.01, 0)).of("m"),
            Rounding(scene, trace, steps_of(0.01, std::numeric_limits<double>::epsilon())).of("m"));
}

}  // namespace
}  // namespace plumb::bounds_test
