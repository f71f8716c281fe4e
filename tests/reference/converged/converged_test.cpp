#include "reference/converged/converged.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <string>

#include "reports/judge/observe.h"
#include "reports/run/run.h"
#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/vec.h"

namespace plumb::converged_test {
namespace {

using ::testing::StartsWith;

constexpr double frame = 1.0 / 60;

std::vector<double> frames(double duration) {
  std::vector<double> times;
  for (std::size_t i = 0; i <= steps_in(duration, frame); ++i) times.push_back(static_cast<double>(i) * frame);
  return times;
}

Scene scene_of(const char* name, const Parameters& changes) {
  const Scenario& scenario = *Catalog<Scenario>::find(name);
  return scenario.scene(complete(scenario, changes));
}

// The largest ratio of actual to claimed error over all times and bodies.
struct Worst {
  double ratio = 0;
  std::string where;

  void compare(double off, double claimed, const std::string& what) {
    const double now = off == 0 ? 0 : off / claimed;
    if (now <= ratio) return;
    ratio = now;
    where = what + " off by " + std::to_string(off) + ", claimed " + std::to_string(claimed);
  }
};

Worst worst_of(const Scene& scene, const Converged& converged, const Truth& truth) {
  Worst worst;
  for (std::size_t moment = 0; moment < converged.times().size(); ++moment) {
    const double time = converged.times()[moment];
    if (time > converged.valid_until()) break;
    const auto right = truth.at(time);
    if (!right) break;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const BodyState& there = (*right)[i];
      const BodyState& here = converged.states(moment)[i];
      const StateError& error = converged.errors(moment)[i];
      const std::string at = scene.bodies[i].name + " at " + std::to_string(time) + " s: ";
      worst.compare(length(here.position - there.position), error.position, at + "place");
      worst.compare(std::abs(here.angle - there.angle), error.angle, at + "angle");
      worst.compare(length(here.velocity - there.velocity), error.velocity, at + "velocity");
      worst.compare(std::abs(here.angular_velocity - there.angular_velocity), error.angular_velocity, at + "spin");
    }
  }
  return worst;
}

TEST(Converged, AgreesWithEveryClosedFormWithinItsError) {
  int met = 0;
  int to_the_end = 0;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    if (scenario->closed_form.empty()) continue;
    for (const Variant& variant : scenario->variants) {
      const Scene scene = scenario->scene(complete(*scenario, variant.changes));
      const Engine& closed_form = *Catalog<Engine>::find(scenario->closed_form);
      if (!closed_form.unsupported(scene, {}).empty()) continue;
      const Converged converged(scene, frames(scene.duration));
      const Worst worst = worst_of(scene, converged, Truth(closed_form, scene));
      EXPECT_LE(worst.ratio, 1) << scenario->name << ' ' << variant.label << ": " << worst.where;
      EXPECT_GT(converged.valid_until(), 0) << scenario->name << ' ' << variant.label;
      ++met;
      to_the_end += converged.reason().empty();
    }
  }
  EXPECT_GE(met, 50);
  EXPECT_GE(to_the_end, met - 2) << "two sliding ladders end early: their errors are of first order only";
}

TEST(Converged, EndsAChaoticSceneAtItsHorizon) {
  const Converged wild(scene_of("double-pendulum", {}), frames(5));
  EXPECT_GT(wild.valid_until(), 1);
  EXPECT_LT(wild.valid_until(), 4);
  EXPECT_THAT(wild.reason(), StartsWith("does not converge: at t = "));
  const Converged calm(scene_of("double-pendulum", {{"angle", 5}}), frames(5));
  EXPECT_GE(calm.valid_until(), 5 - 1e-9);
  EXPECT_EQ(calm.reason(), "");
}

// Lagrange's equations of two uniform rods of length 1 m and mass 1 kg (the mass cancels), in the angles from the
// vertical.
TEST(Converged, AgreesWithAnIndependentIntegrationOfTheDoublePendulum) {
  constexpr double g = 10;
  constexpr double inertia = (1 + 0.1 * 0.1) / 12;
  const auto slope = [](const std::array<double, 4>& y) {
    const double a = y[0] - y[1];
    const double m11 = inertia + 1.25;
    const double m12 = std::cos(a) / 2;
    const double m22 = inertia + 0.25;
    const double f1 = -std::sin(a) / 2 * y[3] * y[3] - 1.5 * g * std::sin(y[0]);
    const double f2 = std::sin(a) / 2 * y[2] * y[2] - 0.5 * g * std::sin(y[1]);
    const double det = m11 * m22 - m12 * m12;
    return std::array<double, 4>{y[2], y[3], (m22 * f1 - m12 * f2) / det, (m11 * f2 - m12 * f1) / det};
  };
  const double start = 2 * std::acos(-1.0) / 3;
  const Converged wild(scene_of("double-pendulum", {}), frames(2));
  std::array<double, 4> y{start, start, 0, 0};
  constexpr int fine = 100;
  for (std::size_t moment = 1; moment < wild.times().size(); ++moment) {
    for (int i = 0; i < fine; ++i) y = runge_kutta(y, frame / fine, slope);
    for (std::size_t rod : {0u, 1u}) {
      const BodyState& state = wild.states(moment)[rod + 1];
      const StateError& error = wild.errors(moment)[rod + 1];
      EXPECT_NEAR(state.angle, y[rod], error.angle) << wild.times()[moment];
      EXPECT_NEAR(state.angular_velocity, y[rod + 2], error.angular_velocity) << wild.times()[moment];
    }
    EXPECT_LT(wild.errors(moment)[2].angle, 1e-4);
  }
}

TEST(Converged, EndsWhereItsBudgetEnds) {
  const Converged converged(scene_of("pyramid", {}), frames(3), {.budget = 1000});
  EXPECT_GT(converged.valid_until(), 0);
  EXPECT_LT(converged.valid_until(), 0.1) << "15 coarsest steps of each body for every moment";
  EXPECT_THAT(converged.reason(), StartsWith("over budget: 3 halvings need"));
}

TEST(Converged, NeedsTimesInAscendingOrder) {
  const Scene scene = scene_of("spring", {});
  EXPECT_THROW(Converged(scene, {1, 0.5}), std::invalid_argument);
  EXPECT_THROW(Converged(scene, {}), std::invalid_argument);
  EXPECT_THROW(Converged(scene, {-1, 0}), std::invalid_argument);
}

TEST(Converged, RunsAsASimulationThatEndsWhereItIsNoLongerValid) {
  const Scene scene = scene_of("double-pendulum", {});
  const ConvergedTruth truth = converged_truth(scene, frames(5), {});
  const Outcome outcome = run(scene, {&truth.engine, {}}, frame);
  ASSERT_EQ(outcome.status, Status::ok);
  EXPECT_DOUBLE_EQ(outcome.trace->times().back(), truth.answer->valid_until());
  EXPECT_EQ(outcome.trace->state_at(2, 1).angle, truth.answer->states(60)[2].angle);
}

TEST(Converged, SupportsNoSceneIfTheRefinementWasRefused) {
  const Scene scene = scene_of("pyramid", {});
  const ConvergedTruth truth = converged_truth(scene, frames(3), {.budget = 10});
  const Outcome outcome = run(scene, {&truth.engine, {}}, frame);
  EXPECT_EQ(outcome.status, Status::not_supported);
  EXPECT_THAT(outcome.reason, StartsWith("over budget"));
}

}  // namespace
}  // namespace plumb::converged_test
