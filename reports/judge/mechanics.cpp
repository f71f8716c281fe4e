#include "reports/judge/mechanics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "reports/judge/overlap.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

Vec point_of(const BodyState& state, Vec local) { return state.position + rotated(local, state.angle); }

// One end of a spring.
struct SpringEnd {
  Vec arm;  // m, from the centre of mass
  Vec point, velocity;
};

SpringEnd end_of(std::optional<std::size_t> body, Vec anchor, std::span<const Mass> masses,
                 std::span<const BodyState> states) {
  if (!body) return {{}, anchor, {}};
  const BodyState& state = states[*body];
  const Vec arm = rotated(anchor - masses[*body].center, state.angle);
  return {arm, state.position + arm, state.velocity + state.angular_velocity * Vec{-arm.y, arm.x}};
}

// The ends of a spring, and the force on its first, N; the second's is the opposite.
struct Pulled {
  SpringEnd a, b;
  Vec pull;
};

Pulled pulled(const Spring& spring, std::span<const Mass> masses, std::span<const BodyState> states) {
  const SpringEnd a = end_of(spring.a, spring.anchor_a, masses, states);
  const SpringEnd b = end_of(spring.b, spring.anchor_b, masses, states);
  const double distance = length(b.point - a.point);
  if (distance == 0) return {a, b, {}};
  const Vec along = 1 / distance * (b.point - a.point);
  const double rate = dot(along, b.velocity - a.velocity);
  return {a, b, (spring.stiffness * (distance - spring.length) + spring.damping * rate) * along};
}

// The extent of all dynamic bodies along gravity, m.
double height_of(const Scene& scene, Vec down, const std::vector<BodyState>& start, std::span<const Mass> masses) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Interval all{infinity, -infinity};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (masses[i].mass == 0) continue;
    for (const Shape& shape : scene.bodies[i].shapes) {
      const auto one =
          range_along(down, placed(outline_of(shape.geometry, masses[i].center), start[i].position, start[i].angle));
      if (one) all = {std::min(all.low, one->low), std::max(all.high, one->high)};
    }
  }
  return std::max(0.0, all.high - all.low);
}

}  // namespace

bool is_driven(const Body& body) {
  const bool spins = body.type == BodyType::dynamic && body.fixed_rotation && body.angular_velocity != 0;
  return is_carried(body) || spins;
}

std::vector<BodyState> initial_states(const Scene& scene) {
  std::vector<BodyState> states;
  for (const Body& body : scene.bodies) {
    states.push_back({.position = body.position + rotated(mass_of(body).center, body.angle),
                      .angle = body.angle,
                      .velocity = start_velocity(body),
                      .angular_velocity = body.angular_velocity});
  }
  return states;
}

std::vector<BodyState> moved_on(std::span<const BodyState> states, double time) {
  std::vector<BodyState> ahead(states.begin(), states.end());
  for (BodyState& state : ahead) {
    state.position = state.position + time * state.velocity;
    state.angle += time * state.angular_velocity;
  }
  return ahead;
}

// The middle of a step; and one for each radian that a body turns in it, as springs turn with their anchors.
std::size_t places_on_the_way(std::span<const BodyState> then, double dt) {
  constexpr double most = 63;  // ten revolutions
  double turn = 1;
  for (const BodyState& state : then) turn = std::max(turn, std::abs(state.angular_velocity) * dt);
  return static_cast<std::size_t>(std::min(turn, most));
}

std::vector<Force> forces_of(const Scene& scene) {
  std::vector<Force> forces = scene.forces;
  const auto local = [&](std::size_t body, Vec point) {
    return rotated(point - scene.bodies[body].position, -scene.bodies[body].angle);
  };
  for (const Joint& joint : scene.joints) {
    const JointFacts facts = facts_of(joint);
    if (facts.keeps != JointFacts::Keeps::spring) continue;
    forces.emplace_back(Spring{.a = facts.a,
                               .b = facts.b,
                               .anchor_a = local(facts.a, facts.anchor_a),
                               .anchor_b = local(facts.b, facts.anchor_b),
                               .stiffness = facts.stiffness,
                               .length = facts.length,
                               .damping = facts.damping});
  }
  return forces;
}

Conserved::Conserved(const Scene& scene) : scene_(scene) {
  for (const Body& body : scene.bodies) masses_.push_back(mass_of(body));
  for (const Force& force : forces_of(scene)) {
    const auto* spring = std::get_if<Spring>(&force);
    if (spring == nullptr) continue;
    elastics_.push_back({.a = spring->a,
                         .b = spring->b,
                         .at_a = spring->a ? spring->anchor_a - masses_[*spring->a].center : spring->anchor_a,
                         .at_b = spring->anchor_b - masses_[spring->b].center,
                         .stiffness = spring->stiffness,
                         .length = spring->length});
  }
}

// The acceleration k/r^n towards `from` has the potential -k/((n-1) r^(n-1)) per kg, and k ln r for n = 1. If the
// attraction is mutual, the opposite force makes this the potential of the pair.
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
  for (const Elastic& elastic : elastics_) {
    const Vec a = elastic.a ? point_of(states[*elastic.a], elastic.at_a) : elastic.at_a;
    const double stretch = length(point_of(states[elastic.b], elastic.at_b) - a) - elastic.length;
    energy.potential += elastic.stiffness * stretch * stretch / 2;
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

AppliedForces::AppliedForces(const Scene& scene) : scene_(scene), forces_(forces_of(scene)), conserved_(scene) {}

// m k / r^n towards the centre; zero at the centre, where there is no direction.
Vec AppliedForces::attracted(const Attraction& attraction, std::size_t body, std::span<const BodyState> states) const {
  if (body == attraction.from || masses()[body].mass == 0) return {};
  const Vec towards = states[attraction.from].position - states[body].position;
  const double r = length(towards);
  if (r == 0) return {};
  return masses()[body].mass * attraction.strength / std::pow(r, attraction.exponent + 1) * towards;
}

std::vector<Wrench> AppliedForces::at(std::span<const BodyState> states) const {
  std::vector<Wrench> wrenches(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    wrenches[i].force = masses()[i].mass * scene_.bodies[i].gravity_scale * scene_.gravity;
  }
  for (const Force& force : forces_) {
    if (const auto* attraction = std::get_if<Attraction>(&force)) {
      for (std::size_t i = 0; i < states.size(); ++i) {
        const Vec pull = attracted(*attraction, i, states);
        wrenches[i].force = wrenches[i].force + pull;
        if (!attraction->mutual) continue;
        wrenches[attraction->from].force = wrenches[attraction->from].force - pull;
      }
    } else if (const auto* spring = std::get_if<Spring>(&force)) {
      const auto& [a, b, pull] = pulled(*spring, masses(), states);
      if (spring->a) {
        wrenches[*spring->a].force = wrenches[*spring->a].force + pull;
        wrenches[*spring->a].torque += cross(a.arm, pull);
      }
      wrenches[spring->b].force = wrenches[spring->b].force - pull;
      wrenches[spring->b].torque -= cross(b.arm, pull);
    } else if (const auto* constant = std::get_if<Constant>(&force)) {
      wrenches[constant->body].force = wrenches[constant->body].force + constant->force;
      wrenches[constant->body].torque += constant->torque;
    }
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (masses()[i].mass == 0) wrenches[i] = {};
    if (masses()[i].inertia == 0) wrenches[i].torque = 0;
  }
  return wrenches;
}

std::vector<std::vector<BodyState>> AppliedForces::passages(std::span<const BodyState> states, double time) const {
  std::vector<std::vector<BodyState>> all;
  const auto pass = [&](Vec line, Vec velocity) {
    const double squared = dot(velocity, velocity);
    const double then = squared > 0 ? -dot(line, velocity) / squared : 0;
    const bool on_the_way = then * time > 0 && std::abs(then) < std::abs(time);
    const double distance = length(line + then * velocity);
    if (on_the_way && distance < std::abs(time) * length(velocity)) all.push_back(moved_on(states, then));
  };
  for (const Force& force : forces_) {
    if (const auto* spring = std::get_if<Spring>(&force)) {
      const auto& [a, b, pull] = pulled(*spring, masses(), states);
      pass(b.point - a.point, b.velocity - a.velocity);
    }
    const auto* attraction = std::get_if<Attraction>(&force);
    for (std::size_t i = 0; attraction != nullptr && i < states.size(); ++i) {
      const BodyState& from = states[attraction->from];
      if (masses()[i].mass > 0) pass(states[i].position - from.position, states[i].velocity - from.velocity);
    }
  }
  return all;
}

std::vector<WrenchError> AppliedForces::change_in(std::span<const BodyState> then, std::span<const BodyState> now,
                                                  double dt) const {
  std::vector<WrenchError> errors(then.size());
  const auto is_constant = [](const Force& force) { return std::holds_alternative<Constant>(force); };
  if (std::all_of(forces_.begin(), forces_.end(), is_constant)) return errors;
  const std::vector<Wrench> start = at(then);
  const std::vector<Wrench> end = at(now);
  std::vector<std::vector<Wrench>> on_the_way;
  const std::size_t places = places_on_the_way(then, dt);
  for (std::size_t place = 1; place <= places; ++place) {
    on_the_way.push_back(at(moved_on(then, dt * static_cast<double>(place) / static_cast<double>(places + 1))));
  }
  for (const auto& passing : passages(then, dt)) on_the_way.push_back(at(passing));
  for (const auto& passing : passages(now, -dt)) on_the_way.push_back(at(passing));
  const std::vector<Wrench> ahead = at(moved_on(then, dt));
  const std::vector<Wrench> behind = at(moved_on(now, -dt));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double force = length(end[i].force - start[i].force) / 2;
    const double torque = std::abs(end[i].torque - start[i].torque) / 2;
    const Vec mean = 0.5 * (start[i].force + end[i].force);
    const double mean_torque = (start[i].torque + end[i].torque) / 2;
    double most_force = force;
    double most_torque = torque;
    for (const std::vector<Wrench>& there : on_the_way) {
      most_force = std::max(most_force, length(there[i].force - mean));
      most_torque = std::max(most_torque, std::abs(there[i].torque - mean_torque));
    }
    errors[i].force =
        force + most_force + (length(ahead[i].force - start[i].force) + length(end[i].force - behind[i].force)) / 8;
    errors[i].torque = torque + most_torque +
                       (std::abs(ahead[i].torque - start[i].torque) + std::abs(end[i].torque - behind[i].torque)) / 8;
  }
  return errors;
}

// With U(r) the potential, dU/dt = -F.(v - v_centre): the work done on the body, F.v, exceeds the loss of potential by
// F.v_centre. What moves an end of a spring regardless works against its pull.
double AppliedForces::power(std::span<const BodyState> states) const {
  double power = 0;
  for (const Force& force : forces_) {
    if (const auto* spring = std::get_if<Spring>(&force)) {
      const auto& [a, b, pull] = pulled(*spring, masses(), states);
      if (spring->a && masses()[*spring->a].mass == 0) power -= dot(pull, a.velocity);
      if (masses()[spring->b].mass == 0) power += dot(pull, b.velocity);
    }
    const auto* attraction = std::get_if<Attraction>(&force);
    if (attraction == nullptr || (attraction->mutual && masses()[attraction->from].mass > 0)) continue;
    for (std::size_t i = 0; i < states.size(); ++i) {
      power += dot(attracted(*attraction, i, states), states[attraction->from].velocity);
    }
  }
  return power;
}

double AppliedForces::potential(std::span<const BodyState> states) const {
  double potential = 0;
  for (const Force& force : forces_) {
    const auto* constant = std::get_if<Constant>(&force);
    if (constant == nullptr || masses()[constant->body].mass == 0) continue;
    const BodyState& state = states[constant->body];
    potential -= dot(constant->force, state.position) + constant->torque * state.angle;
  }
  return potential;
}

double energy_range(const Scene& scene, const Trace* truth) {
  const Conserved conserved(scene);
  const std::vector<BodyState> start = initial_states(scene);
  const Energy energy = conserved.energy(start);
  double weight = 0;      // N, the sum of all weights
  double by_gravity = 0;  // J, its share of the potential energy
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const double scaled_mass = conserved.masses()[i].mass * scene.bodies[i].gravity_scale;
    weight += std::abs(scaled_mass) * length(scene.gravity);
    by_gravity -= scaled_mass * dot(scene.gravity, start[i].position);
  }
  double range = energy.kinetic() + std::abs(energy.potential - by_gravity);
  if (weight > 0) {
    const Vec down = 1 / length(scene.gravity) * scene.gravity;
    range += weight * height_of(scene, down, start, conserved.masses());
  }
  for (std::size_t i = 0; truth != nullptr && i < truth->size(); ++i) {
    range = std::max(range, conserved.energy(truth->states(i)).kinetic());
  }
  return range;
}

}  // namespace plumb
