#include <algorithm>
#include <memory>
#include <variant>

#include "reports/judge/mechanics.h"
#include "reports/study/stability/map.h"

namespace plumb::maps::spring {
namespace {

constexpr int steps = 8192;
constexpr double amplitude = 0.01;  // m; far below what engines clamp in a step

// For k = w dt, bounded motion under symplectic Euler swells and shrinks with the beat between spring and step, by a
// factor (1 + k/2)/(1 - k/2) of its energy: 2000 where k is 0.1 % short of 2. More is growth; and so is more in the
// second half of a run than there ever was in the first: explicit Euler's (1 + k^2)^(steps/2) shows from k = 0.005 on.
Watch grows(const std::shared_ptr<const Scene>& scene) {
  constexpr double grown = 1.1;
  constexpr double swollen = 4000;
  const auto conserved = std::make_shared<Conserved>(*scene);
  const double start = conserved->energy(initial_states(*scene)).total();
  return {
      "gains energy: in the second half of 8192 steps it has 10 % more than ever in the first, or at any time 4000 "
      "times what it had",
      [=, most = 0.0](const Moment& now) mutable {
        const double energy = conserved->energy(now.states).total();
        if (now.time < scene->duration / 2) most = std::max(most, energy);
        const bool grew = energy > grown * most || energy > swollen * start;
        return grew ? std::optional(Symptom{Fate::gains_energy, 0}) : std::nullopt;
      }};
}

// Put about the origin, where the numbers of floats are as fine as the motion is small.
std::vector<Trial> trials(double dt, double w, const EngineConfig&) {
  Scene scene = scene_of("spring", {{"frequency", w}, {"amplitude", amplitude}});
  scene.duration = steps * dt;
  Spring& spring = std::get<Spring>(scene.forces[0]);
  spring.anchor_a.x -= spring.length;
  scene.bodies[0].position.x = amplitude;
  Trial trial{.scene = std::make_shared<const Scene>(std::move(scene)), .dt = dt};
  trial.watches.push_back(grows(trial.scene));
  return {trial};
}

std::optional<double> theory(const EngineConfig& config, double w) {
  const auto limit = config.engine->stepping(config.settings, 1).spring_limit;
  return limit ? std::optional(*limit / w) : std::nullopt;
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "spring",
     .question = "Up to which step does a mass on a spring stay bounded?",
     .x = {.name = "dt", .unit = "s", .from = 0.003, .to = 1, .logarithmic = true},
     .y = Axis{.name = "frequency", .unit = "rad/s", .from = 4, .to = 60, .logarithmic = true},
     .typical = 60,
     .trials = trials,
     .boundaries = {{.name = "bounded",
                     .grain = 0.001,
                     .theory = theory,
                     .source = "the integrator's eigenvalues on x'' = -w^2 x: w h = 2 for symplectic Euler and Verlet, "
                               "2.83 for RK4, 0 for explicit Euler; h is the sub-step where the force is met in each",
                     .agreement = 0.01}}}};

}  // namespace
}  // namespace plumb::maps::spring
