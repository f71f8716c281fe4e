#include "reports/run/horizon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>

#include "reference/scene_facts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"
#include "scenarios/random.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr std::size_t steps_per_moment = 2;
constexpr std::size_t steps_to_tell = 4;  // a change of acceleration by a contact
constexpr int random_directions = 3;
constexpr double displacement_shares[] = {1e-5, 1e-3, 1e-2, 1e-1};  // of the smallest body

// m, of the rim; of a body that has none the size of the smallest.
double rim_of(const Scene& scene, const Body& body) {
  const double radius = bounding_radius(body);
  return radius > 0 ? radius : smallest_body(scene);
}

}  // namespace

EngineConfig our_config() {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  return {&ours, complete(ours, {{"precision", "double"}})};
}

Scene displaced(const Scene& scene, double size, std::uint64_t seed) {
  Scene moved = perturbed(scene, size, seed);
  Random random(~seed);
  for (Body& body : moved.bodies) {
    if (body.type == BodyType::dynamic) body.angle += random.between(-size, size) / rim_of(scene, body);
  }
  return moved;
}

Growth::Growth(const Scene& scene, double dt, double until) : dt_(dt), bodies_(scene.bodies.size()) {
  Scene shortened = scene;
  shortened.duration = until;
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) bounces_ = bounces_ || shape.surface.restitution > 0;
  }
  for (const Body& body : scene.bodies) radius_.push_back(rim_of(scene, body));
  const EngineConfig config = our_config();
  const Outcome outcome = run(shortened, config, dt / steps_per_moment);
  if (outcome.status != Status::ok) return;
  const Trace& trace = *outcome.trace;
  const std::vector<Stress> fine = stress_along(scene, trace);
  const Conserved conserved(scene);
  const auto masses = conserved.masses();
  double weight = 0;
  for (const Mass& mass : masses) weight += mass.mass * length(scene.gravity);
  double force = weight;
  double momentum = 0;
  for (std::size_t step = 0; step < fine.size(); ++step) {
    double together = 0;
    double moving = 0;
    for (std::size_t i = 0; step > 0 && i < bodies_; ++i) {
      const Vec change = trace.states(step)[i].velocity - trace.states(step - 1)[i].velocity;
      together += masses[i].mass * length(change) / (trace.time(step) - trace.time(step - 1));
      moving += masses[i].mass * (length(trace.states(step)[i].velocity) +
                                  radius_[i] * std::abs(trace.states(step)[i].angular_velocity));
    }
    momentum = std::max(momentum, moving);
    if (step > 0 && fine[step].pushed == fine[step - 1].pushed) force = std::max(force, weight + together);
    if (step % steps_per_moment != 0) continue;
    stress_.push_back(fine[step]);
    // A change of acceleration by a contact is known some steps after it.
    const Stress& later = fine[std::min(step + steps_to_tell, fine.size() - 1)];
    stress_.back().bends = later.bends;
    stress_.back().jolts = later.jolts;
    force_.push_back(force);
    momentum_.push_back(momentum);
  }
  for (const double share : displacement_shares) displace(shortened, config, trace, share * smallest_body(scene));
}

void Growth::displace(const Scene& scene, const EngineConfig& config, const Trace& undisturbed, double size) {
  const Conserved conserved(scene);
  Displaced displaced{.size = size, .growth = std::vector<PoseShift>(stress_.size() * bodies_)};
  for (int seed = 1; seed <= random_directions; ++seed) {
    const Scene moved = plumb::displaced(scene, size, static_cast<std::uint64_t>(seed));
    const Outcome outcome = run(moved, config, dt_ / steps_per_moment);
    if (!outcome.trace) continue;
    const double usual = size * std::sqrt(2.0 / 3);  // root mean square of such displacements
    std::vector<PoseShift> so_far(bodies_);
    for (std::size_t moment = 0; moment < stress_.size(); ++moment) {
      const std::size_t step = std::min(moment * steps_per_moment, outcome.trace->size() - 1);
      const auto here = undisturbed.states(step);
      const auto there = outcome.trace->states(step);
      const double energy = std::abs(conserved.energy(here).total() - conserved.energy(there).total()) / usual;
      for (std::size_t i = 0; i < bodies_; ++i) {
        PoseShift& most = so_far[i];
        most.place = std::max(most.place, length(here[i].position - there[i].position) / usual);
        most.angle = std::max(most.angle, std::abs(here[i].angle - there[i].angle) / usual);
        most.energy = std::max(most.energy, energy);
        PoseShift& growth = displaced.growth[moment * bodies_ + i];
        growth = {std::max(growth.place, most.place), std::max(growth.angle, most.angle),
                  std::max(growth.energy, most.energy)};
      }
    }
  }
  displaced_.push_back(std::move(displaced));
}

MethodError Growth::own_error(const Stepping& stepping, std::size_t moment) const {
  return method_error(stepping, stress_[moment], bounces_);
}

std::optional<Growth::Factor> Growth::factor(double size, std::size_t moment, std::size_t body) const {
  PoseShift worst{1, 1 / radius_[body], 0};
  for (const Displaced& one : displaced_) {
    const PoseShift& growth = one.growth[moment * bodies_ + body];
    worst = {std::max(worst.place, growth.place), std::max(worst.angle, growth.angle),
             std::max(worst.energy, growth.energy)};
    if (one.size >= size) return Factor{worst, one.size};
  }
  return std::nullopt;
}

std::optional<PoseShift> Growth::allowance(const Stepping& stepping, std::size_t moment, std::size_t body) const {
  const MethodError own = own_error(stepping, moment);
  const auto found = factor(own.place, moment, body);
  if (!found) return std::nullopt;
  const PoseShift& worst = found->per_metre;
  return PoseShift{worst.place * own.place, worst.angle * own.place,
                   (worst.energy + force_[moment]) * own.place + momentum_[moment] * own.speed};
}

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

constexpr std::size_t refined_steps = 2;  // of the refined engine, for one of the others

// Fewer runs tell nothing: the probability that all of six lie above six others by chance is 1e-3.
constexpr std::size_t fewest_members = 6;

std::size_t body_steps(const Scene& scene, double dt) { return scene.bodies.size() * steps_in(scene.duration, dt); }

// As many runs of the refined engine as take the time of all runs of another, if the budget allows them; none if they
// are too few.
int refined_members(const Scene& scene, double dt, int members, std::size_t budget) {
  const std::size_t cost = refined_steps * body_steps(scene, dt);
  const std::size_t wanted = std::max(static_cast<std::size_t>(members) / refined_steps, fewest_members);
  const std::size_t runs = std::min(wanted, budget / std::max<std::size_t>(cost, 1));
  return runs < fewest_members ? 0 : static_cast<int>(runs);
}

std::string config_label(const EngineConfig& config) { return label_of(config.engine->name, config.method()); }

}  // namespace

int ensemble_members(const Scene& scene, double dt, int most) {
  const auto wanted = static_cast<std::size_t>(most);
  const std::size_t runs = wanted * usual_budget / std::max<std::size_t>(body_steps(scene, dt), 1);
  return static_cast<int>(std::min(wanted, std::max(runs, fewest_members)));
}

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
    std::optional<double> diverged;
    std::size_t moment = 0;
    const auto compare = [&](double time, std::span<const BodyState> states) {
      if (moment == trace.size() || (horizon && time >= *horizon)) return false;
      if (have_diverged(scene, trace.states(moment), states, divergence_distance(scene))) diverged = time;
      ++moment;
      return !diverged;
    };
    const Outcome other = watch(perturbed(scene, size, static_cast<std::uint64_t>(seed)), config, dt, 1, compare);
    if (diverged && other.status != Status::not_supported) horizon = diverged;
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
    const Scene start = perturbed(scene, size, first_seed + static_cast<std::uint64_t>(member));
    Trace places(scene.bodies.size());
    places.reserve(steps_in(scene.duration, dt) + 1);
    const Outcome outcome = watch(start, config, dt, 1, [&](double time, std::span<const BodyState> states) {
      places.record(time, states, {});
      return true;
    });
    if (outcome.status == Status::ok) add_run(samples, scene, places);
  }
  return samples;
}

void compare_beyond_horizon(const Case& test_case, std::span<const EngineConfig> configs, double dt, int most,
                            std::size_t budget, std::span<RunRecord> records, std::span<Comparison> comparisons) {
  const Scene& scene = *test_case.scene;
  const EngineConfig refined_engine = refined_config();
  double size = 0;
  std::optional<std::optional<double>> known;  // the scene's horizon, if its engine is among these
  std::vector<EngineConfig> compared;          // those that are not wrong anyway
  for (const EngineConfig& config : configs) {
    size = std::max(size, smallest_difference(scene, config.engine->stepping(config.settings, dt)));
    for (RunRecord& record : records) {
      if (label_of(record.engine, record.method) != config_label(config)) continue;
      const auto own = horizon_of(scene, config, dt, *record.trace);
      if (own) record.metrics["horizon"] = {*own, "s"};
      if (config.engine == refined_engine.engine && config.settings == refined_engine.settings) known = own;
      if (record.verdict != Verdict::wrong && record.verdict != Verdict::failed) compared.push_back(config);
    }
  }
  const auto horizon = known ? *known : horizon_of(scene, dt);
  const int members = ensemble_members(scene, dt, most);
  const int refined_runs = refined_members(scene, dt, members, budget);
  if (!horizon || (comparisons.empty() && refined_runs == 0)) return;
  Ensembles ensembles;
  for (const EngineConfig& config : compared) {
    ensembles[config_label(config)] = run_ensemble(scene, config, dt, size, members, first_ensemble_seed);
  }
  for (Comparison& comparison : comparisons) {
    const auto a = ensembles.find(comparison.a);
    const auto b = ensembles.find(comparison.b);
    if (a == ensembles.end() || b == ensembles.end()) continue;
    add_ensembles(comparison, compare_ensembles(a->second, b->second), *horizon, members);
  }
  if (refined_runs == 0) return;
  const auto refined = run_ensemble(scene, refined_engine, dt / static_cast<double>(refined_steps), size, refined_runs,
                                    first_ensemble_seed);
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
