#include "reports/run/horizon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "reference/scene_facts.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// Differences grow at the same rate in almost any direction, but one perturbation may point in a direction that
// shrinks.
constexpr int perturbed_runs = 2;

constexpr std::uint64_t first_ensemble_seed = 1;

bool have_diverged(const Scene& scene, std::span<const BodyState> a, std::span<const BodyState> b, double limit) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && !(length(a[i].position - b[i].position) <= limit)) return true;
  }
  return false;
}

EngineConfig refined_config() {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  return {&ours, complete(ours, {{"precision", "double"}})};
}

using Ensembles = std::map<std::string, std::vector<EnsembleSample>>;  // by engine label

constexpr int refined_steps = 2;  // of the refined engine, for one of the others

// As many runs of the refined engine as the budget allows, or none if they are too few to tell: the probability that
// all of six lie above sixteen others by chance is 1e-5.
int refined_members(const Scene& scene, double dt, int members, std::size_t budget) {
  constexpr std::size_t fewest = 6;
  const std::size_t cost = scene.bodies.size() * steps_in(scene.duration, dt) * refined_steps;
  const std::size_t runs = std::min(static_cast<std::size_t>(members), budget / std::max<std::size_t>(cost, 1));
  return runs < fewest ? 0 : static_cast<int>(runs);
}

std::string config_label(const EngineConfig& config) { return label_of(config.engine->name, config.method()); }

}  // namespace

double smallest_difference(const Scene& scene, const Stepping& stepping) {
  constexpr double billionth = 1e-9;  // m
  double farthest = 0;
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic) farthest = std::max(farthest, length(body.position));
  }
  return std::max(billionth, 8 * stepping.epsilon * farthest);
}

double divergence_distance(const Scene& scene) { return 0.1 * smallest_body(scene); }

std::optional<double> horizon_of(const Scene& scene, const EngineConfig& config, double dt, const Trace& trace) {
  const double size = smallest_difference(scene, config.engine->stepping(config.settings, dt));
  std::optional<double> horizon;
  for (int seed = 1; seed <= perturbed_runs; ++seed) {
    const Outcome other = run(perturbed(scene, size, static_cast<std::uint64_t>(seed)), config, dt);
    if (!other.trace) continue;
    const std::size_t both = std::min(trace.size(), other.trace->size());
    for (std::size_t moment = 0; moment < both; ++moment) {
      if (horizon && trace.time(moment) >= *horizon) break;
      if (!have_diverged(scene, trace.states(moment), other.trace->states(moment), divergence_distance(scene))) {
        continue;
      }
      horizon = trace.time(moment);
      break;
    }
  }
  return horizon;
}

std::optional<double> horizon_of(const Scene& scene, double dt) {
  const EngineConfig config = refined_config();
  const Outcome outcome = run(scene, config, dt);
  if (outcome.status != Status::ok) return std::nullopt;
  return horizon_of(scene, config, dt, *outcome.trace);
}

std::vector<EnsembleSample> run_ensemble(const Scene& scene, const EngineConfig& config, double dt, double size,
                                         int members, std::uint64_t first_seed) {
  std::vector<EnsembleSample> samples = empty_samples();
  for (int member = 0; member < members; ++member) {
    const Outcome outcome = run(perturbed(scene, size, first_seed + static_cast<std::uint64_t>(member)), config, dt);
    if (outcome.status == Status::ok) add_run(samples, scene, *outcome.trace);
  }
  return samples;
}

void compare_beyond_horizon(const Case& test_case, std::span<const EngineConfig> configs, double dt, int members,
                            std::size_t budget, std::span<RunRecord> records, std::span<Comparison> comparisons) {
  const Scene& scene = *test_case.scene;
  double size = 0;
  for (const EngineConfig& config : configs) {
    size = std::max(size, smallest_difference(scene, config.engine->stepping(config.settings, dt)));
    for (RunRecord& record : records) {
      if (label_of(record.engine, record.method) != config_label(config)) continue;
      if (const auto own = horizon_of(scene, config, dt, *record.trace)) record.metrics["horizon"] = {*own, "s"};
    }
  }
  const auto horizon = horizon_of(scene, dt);
  const int refined_runs = refined_members(scene, dt, members, budget);
  if (!horizon || (comparisons.empty() && refined_runs == 0)) return;
  Ensembles ensembles;
  for (const EngineConfig& config : configs) {
    ensembles[config_label(config)] = run_ensemble(scene, config, dt, size, members, first_ensemble_seed);
  }
  for (Comparison& comparison : comparisons) {
    const auto a = ensembles.find(comparison.a);
    const auto b = ensembles.find(comparison.b);
    if (a == ensembles.end() || b == ensembles.end()) continue;
    add_ensembles(comparison, compare_ensembles(a->second, b->second), *horizon, members);
  }
  if (refined_runs == 0) return;
  const auto refined =
      run_ensemble(scene, refined_config(), dt / refined_steps, size, refined_runs, first_ensemble_seed);
  for (RunRecord& record : records) {
    const auto found = ensembles.find(label_of(record.engine, record.method));
    if (found == ensembles.end()) continue;
    const std::string different = differences_in_words(compare_ensembles(found->second, refined), members);
    if (different.empty()) continue;
    record.reason += fmt::format("{}beyond the horizon at {:.3g} s, from the refined engine's runs {}",
                                 record.reason.empty() ? "" : "; ", *horizon, different);
  }
}

MetricNote horizon_note() {
  return {.name = "horizon",
          .unit = "s",
          .definition =
              "time after which runs of this engine that started up to 1e-9 m apart (or 8 units of round-off "
              "of a body's position, if that is more) differ by a tenth of the smallest body; missing if they "
              "do not by the end",
          .better = "neither"};
}

}  // namespace plumb
