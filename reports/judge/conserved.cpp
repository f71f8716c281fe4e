#include "reports/judge/conserved.h"

#include <cmath>

#include "reports/vec.h"

namespace plumb {
namespace {

Vec point_of(const BodyState& state, Vec local) { return state.position + rotated(local, state.angle); }

}  // namespace

std::vector<BodyState> initial_states(const Scene& scene) {
  std::vector<BodyState> states;
  for (const Body& body : scene.bodies) {
    states.push_back({.position = body.position + rotated(mass_of(body).center, body.angle),
                      .angle = body.angle,
                      .velocity = body.velocity,
                      .angular_velocity = body.angular_velocity});
  }
  return states;
}

Conserved::Conserved(const Scene& scene) : scene_(scene) {
  for (const Body& body : scene.bodies) masses_.push_back(mass_of(body));
  for (const Force& force : scene.forces) {
    if (const auto* spring = std::get_if<Spring>(&force)) {
      ties_.push_back({.a = spring->a,
                       .b = spring->b,
                       .at_a = spring->a ? spring->anchor_a - masses_[*spring->a].center : spring->anchor_a,
                       .at_b = spring->anchor_b - masses_[spring->b].center,
                       .stiffness = spring->stiffness,
                       .length = spring->length});
    }
  }
  // A distance joint with stiffness is a spring whose anchors are given in the world, at the start.
  const std::vector<BodyState> start = initial_states(scene);
  const auto local = [&](std::size_t body, Vec anchor) {
    return rotated(anchor - start[body].position, -start[body].angle);
  };
  for (const Joint& joint : scene.joints) {
    const auto* distance = std::get_if<Distance>(&joint);
    if (distance == nullptr || distance->stiffness == 0) continue;
    ties_.push_back({.a = distance->a,
                     .b = distance->b,
                     .at_a = local(distance->a, distance->anchor_a),
                     .at_b = local(distance->b, distance->anchor_b),
                     .stiffness = distance->stiffness,
                     .length = distance->length});
  }
}

// The acceleration k/r^n towards `from` has, per kg, the potential -k/((n-1) r^(n-1)), and k ln r for n = 1. It serves
// the mutual kind too: there the opposite force makes it the potential of the pair.
double Conserved::potential_of(const Attraction& attraction, std::span<const BodyState> states) const {
  const double n = attraction.exponent;
  double potential = 0;
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    if (i == attraction.from || scene_.bodies[i].type != BodyType::dynamic) continue;
    const double r = length(states[i].position - states[attraction.from].position);
    const double per_mass = n == 1 ? std::log(r) : -std::pow(r, 1 - n) / (n - 1);
    potential += masses_[i].mass * attraction.strength * per_mass;
  }
  return potential;
}

Energy Conserved::energy(std::span<const BodyState> states) const {
  Energy energy;
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    const BodyState& state = states[i];
    const auto& [mass, inertia, center] = masses_[i];
    energy.linear += mass * dot(state.velocity, state.velocity) / 2;
    energy.rotational += inertia * state.angular_velocity * state.angular_velocity / 2;
    energy.potential -= mass * scene_.bodies[i].gravity_scale * dot(scene_.gravity, state.position);
  }
  for (const Tie& tie : ties_) {
    const Vec a = tie.a ? point_of(states[*tie.a], tie.at_a) : tie.at_a;
    const double stretch = length(point_of(states[tie.b], tie.at_b) - a) - tie.length;
    energy.potential += tie.stiffness * stretch * stretch / 2;
  }
  for (const Force& force : scene_.forces) {
    if (const auto* attraction = std::get_if<Attraction>(&force)) energy.potential += potential_of(*attraction, states);
  }
  return energy;
}

Momentum Conserved::momentum(std::span<const BodyState> states) const {
  Momentum momentum;
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    const BodyState& state = states[i];
    const Vec linear = masses_[i].mass * state.velocity;
    momentum.linear = momentum.linear + linear;
    momentum.angular += cross(state.position, linear) + masses_[i].inertia * state.angular_velocity;
  }
  return momentum;
}

}  // namespace plumb
