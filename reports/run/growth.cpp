#include "reports/run/growth.h"

#include <algorithm>
#include <cmath>
#include <span>

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

}  // namespace plumb
