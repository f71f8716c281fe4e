// Maps of joints and springs: a load on a chain, and a mass on a spring.

#include <algorithm>
#include <memory>
#include <variant>

#include "reports/judge/mechanics.h"
#include "reports/study/stability/map.h"

namespace plumb::maps::joints {
namespace {

std::vector<Trial> chain_trials(double ratio, double links, const EngineConfig&) {
  constexpr double link = 0.5;     // m
  constexpr double stretch = 1.1;  // of its length, beyond which a chain has torn
  Trial trial{.scene = std::make_shared<const Scene>(
                  catalog_scene("hanging-chain", {{"ratio", ratio}, {"links", links}, {"angle", 60}})),
              .dt = usual_dt};
  trial.detectors = {separation_detector(trial.scene, 0, trial.scene->bodies.size() - 1, stretch * link * links),
                     energy_detector(trial.scene, 0.1)};
  return {trial};
}

const Catalog<StabilityMap>::Entry chain{
    {.name = "chain",
     .question = "How heavy a load can swing on a chain of light links?",
     .x = {.name = "mass ratio", .from = 1, .to = 10000, .logarithmic = true},
     .y = Axis{.name = "links", .from = 1, .to = 32, .logarithmic = true, .whole = true},
     .typical = 10,
     .trials = chain_trials,
     .boundaries = {{.name = "holds", .resolution = 0.02}}}};

// With k = w dt, the energy of bounded motion under symplectic Euler oscillates with the beat between spring and step
// by a factor (1 + k/2)/(1 - k/2): 2000 where k is 0.1 % below 2. More is growth, and so is more energy in the second
// half of a run than ever in the first: explicit Euler's (1 + k^2)^(steps/2) shows for k of at least 0.005.
Detector growth_detector(const std::shared_ptr<const Scene>& scene) {
  constexpr double largest_growth = 1.1;
  constexpr double largest_beat = 4000;
  const auto conserved = std::make_shared<Conserved>(*scene);
  const double start = conserved->energy(initial_states(*scene)).total();
  return {
      "gains energy: in the second half of 8192 steps the energy is 10 % above its maximum in the first, or at any "
      "time "
      "4000 times that of the start",
      [=, most = 0.0](const ObservedStep& now) mutable {
        const double energy = conserved->energy(now.states).total();
        if (now.time < scene->duration / 2) most = std::max(most, energy);
        const bool grew = energy > largest_growth * most || energy > largest_beat * start;
        return grew ? std::optional(DetectorFinding{FailureMode::gains_energy, 0}) : std::nullopt;
      }};
}

// The mass oscillates about the origin, where the resolution of floats suits so small a motion.
std::vector<Trial> spring_trials(double dt, double w, const EngineConfig&) {
  constexpr int steps = 8192;
  constexpr double amplitude = 0.01;  // m; far below what engines clamp in a step
  Scene scene = catalog_scene("spring", {{"frequency", w}, {"amplitude", amplitude}});
  scene.duration = steps * dt;
  Spring& force = std::get<Spring>(scene.forces[0]);
  force.anchor_a.x -= force.length;
  scene.bodies[0].position.x = amplitude;
  Trial trial{.scene = std::make_shared<const Scene>(std::move(scene)), .dt = dt};
  trial.detectors.push_back(growth_detector(trial.scene));
  return {trial};
}

std::optional<double> spring_theory(const EngineConfig& config, double w) {
  std::string why_not;
  const auto stated = stepping_of(config, 1, why_not);
  return stated && stated->spring_limit ? std::optional(*stated->spring_limit / w) : std::nullopt;
}

const Catalog<StabilityMap>::Entry spring{
    {.name = "spring",
     .question = "Up to which step does a mass on a spring stay bounded?",
     .x = {.name = "dt", .unit = "s", .from = 0.003, .to = 1, .logarithmic = true},
     .y = Axis{.name = "frequency", .unit = "rad/s", .from = 4, .to = 60, .logarithmic = true},
     .typical = 60,
     .trials = spring_trials,
     .boundaries = {{.name = "bounded",
                     .resolution = 0.001,
                     .theory = spring_theory,
                     .source = "the integrator's eigenvalues on x'' = -w^2 x: w h = 2 for symplectic Euler and Verlet, "
                               "2.83 for RK4, 0 for explicit Euler; h is the sub-step if forces are evaluated in each",
                     .agreement = 0.01}}}};

}  // namespace
}  // namespace plumb::maps::joints
