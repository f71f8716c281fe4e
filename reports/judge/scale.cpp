#include "reports/judge/scale.h"

#include <algorithm>
#include <cmath>

#include "reference/scene_facts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr int samples = 64;       // of the truth, evenly over the scene
constexpr double at_rest = 0.01;  // of the floor: where the truth changes by less, the floor is the scale

double or_floor(double change, double floor) { return change >= at_rest * floor ? change : floor; }

// The truth at a few moments. A closed form is evaluated anew for each, so there are not many.
Trace sampled(const Scene& scene, const Truth* truth) {
  Trace trace(scene.bodies.size());
  trace.record(0, initial_states(scene), {});
  if (truth == nullptr) return trace;
  const double until = std::min(truth->until(), scene.duration);
  for (int i = 1; i <= samples; ++i) {
    const double time = until * i / samples;
    if (const auto states = truth->at(time)) trace.record(time, *states, {});
  }
  return trace;
}

}  // namespace

Scales::Scales(const Scene& scene, const Truth* truth) : Scales(scene, sampled(scene, truth)) {}

Scales::Scales(const Scene& scene, const Trace& trace) : scene_(scene), start_(initial_states(scene)) {
  const Conserved conserved(scene);
  const auto masses = conserved.masses();
  double launched = 0;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    if (masses[i].mass > 0) launched = std::max(launched, length(start_[i].velocity));
  }
  double floor_momentum = 0;
  double floor_angular = 0;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    BodyScale one{.size = bounding_radius(scene.bodies[i])};
    if (one.size == 0) one.size = 1;
    for (std::size_t moment = 0; moment < trace.size(); ++moment) {
      const BodyState& state = trace.states(moment)[i];
      one.displacement = std::max(one.displacement, length(state.position - start_[i].position));
      one.turn = std::max(one.turn, std::abs(state.angle - start_[i].angle));
      one.speed = std::max(one.speed, length(state.velocity));
      one.spin = std::max(one.spin, std::abs(state.angular_velocity));
    }
    const double falls = std::sqrt(2 * length(scene.gravity) * std::abs(scene.bodies[i].gravity_scale) * one.size);
    one.slowest = falls > 0 ? falls : launched > 0 ? launched : one.size;
    const auto& [mass, inertia, center] = masses[i];
    floor_momentum += mass * one.slowest;
    floor_angular += mass * one.slowest * one.size;
    weight_ += mass * length(scene.gravity);
    bodies_.push_back(one);
  }
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    double linear = 0;
    double angular = 0;
    for (std::size_t i = 0; i < start_.size(); ++i) {
      const BodyState& state = trace.states(moment)[i];
      linear += masses[i].mass * length(state.velocity);
      angular += masses[i].mass * length(state.position) * length(state.velocity) +
                 masses[i].inertia * std::abs(state.angular_velocity);
    }
    momentum_ = std::max(momentum_, linear);
    angular_momentum_ = std::max(angular_momentum_, angular);
  }
  momentum_ = or_floor(momentum_, floor_momentum);
  angular_momentum_ = or_floor(angular_momentum_, floor_angular);
  energy_ = energy_range(scene, &trace);
}

bool Scales::moves() const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (scene_.bodies[i].type != BodyType::dynamic) continue;
    const BodyScale& one = bodies_[i];
    if (start_[i].velocity != Vec{} || start_[i].angular_velocity != 0) return true;
    if (one.displacement > at_rest * one.size || one.turn > at_rest) return true;
  }
  return false;
}

double Scales::of(const Expectation& expectation, double expected) const {
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene_, expectation.body);
  const BodyScale& scale = bodies_[body];
  const BodyState& start = start_[body];
  switch (expectation.quantity) {
    case Quantity::x:
      return or_floor(std::max(scale.displacement, std::abs(expected - start.position.x)), scale.size);
    case Quantity::y:
    case Quantity::apex:
      return or_floor(std::max(scale.displacement, std::abs(expected - start.position.y)), scale.size);
    case Quantity::angle:
      return or_floor(std::max(scale.turn, std::abs(expected - start.angle)), 1);
    case Quantity::vx:
    case Quantity::vy:
    case Quantity::speed:
      return or_floor(std::max(scale.speed, std::abs(expected)), scale.slowest);
    case Quantity::angular_velocity:
      return or_floor(std::max(scale.spin, std::abs(expected)), scale.slowest / scale.size);
    case Quantity::energy:
    case Quantity::energy_rise:
      return energy_;
    case Quantity::momentum_x:
    case Quantity::momentum_y:
      return momentum_;
    case Quantity::angular_momentum:
      return angular_momentum_;
    case Quantity::load:
      return weight_ > 0 ? weight_ : std::abs(expected);
    case Quantity::landing:
    case Quantity::speed_spread:
      return std::abs(expected);
  }
  return 0;
}

}  // namespace plumb
