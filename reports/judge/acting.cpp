#include "reports/judge/acting.h"

#include <cmath>
#include <optional>
#include <variant>

#include "reports/vec.h"

namespace plumb {
namespace {

struct End {
  Vec arm;  // from the centre of mass
  Vec point, velocity;
};

End end_of(std::optional<std::size_t> body, Vec anchor, std::span<const Mass> masses,
           std::span<const BodyState> states) {
  if (!body) return {{}, anchor, {}};
  const BodyState& state = states[*body];
  const Vec arm = rotated(anchor - masses[*body].center, state.angle);
  return {arm, state.position + arm, state.velocity + state.angular_velocity * Vec{-arm.y, arm.x}};
}

}  // namespace

Acting::Acting(const Scene& scene) : scene_(scene), conserved_(scene) {}

// m k / r^n towards the centre; at the centre itself there is no direction.
Vec Acting::attracted(const Attraction& attraction, std::size_t body, std::span<const BodyState> states) const {
  if (body == attraction.from || masses()[body].mass == 0) return {};
  const Vec towards = states[attraction.from].position - states[body].position;
  const double r = length(towards);
  if (r == 0) return {};
  return masses()[body].mass * attraction.strength / std::pow(r, attraction.exponent + 1) * towards;
}

std::vector<Push> Acting::on(std::span<const BodyState> states) const {
  std::vector<Push> pushes(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    pushes[i].force = masses()[i].mass * scene_.bodies[i].gravity_scale * scene_.gravity;
  }
  for (const Force& force : scene_.forces) {
    if (const auto* attraction = std::get_if<Attraction>(&force)) {
      for (std::size_t i = 0; i < states.size(); ++i) {
        const Vec pull = attracted(*attraction, i, states);
        pushes[i].force = pushes[i].force + pull;
        if (!attraction->mutual) continue;
        pushes[attraction->from].force = pushes[attraction->from].force - pull;
      }
    } else if (const auto* spring = std::get_if<Spring>(&force)) {
      const End a = end_of(spring->a, spring->anchor_a, masses(), states);
      const End b = end_of(spring->b, spring->anchor_b, masses(), states);
      const double distance = length(b.point - a.point);
      if (distance == 0) continue;
      const Vec along = 1 / distance * (b.point - a.point);
      const double rate = dot(along, b.velocity - a.velocity);
      const Vec pull = (spring->stiffness * (distance - spring->length) + spring->damping * rate) * along;
      if (spring->a) {
        pushes[*spring->a].force = pushes[*spring->a].force + pull;
        pushes[*spring->a].torque += cross(a.arm, pull);
      }
      pushes[spring->b].force = pushes[spring->b].force - pull;
      pushes[spring->b].torque -= cross(b.arm, pull);
    } else if (const auto* constant = std::get_if<Constant>(&force)) {
      pushes[constant->body].force = pushes[constant->body].force + constant->force;
      pushes[constant->body].torque += constant->torque;
    }
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (masses()[i].mass == 0) pushes[i] = {};
    if (masses()[i].inertia == 0) pushes[i].torque = 0;
  }
  return pushes;
}

// With U(r) the potential of the distance, dU/dt = -F.(v - v_centre): the work done on the body, F.v, is more than
// what the potential loses by F.v_centre.
double Acting::power(std::span<const BodyState> states) const {
  double power = 0;
  for (const Force& force : scene_.forces) {
    const auto* attraction = std::get_if<Attraction>(&force);
    if (attraction == nullptr || (attraction->mutual && masses()[attraction->from].mass > 0)) continue;
    for (std::size_t i = 0; i < states.size(); ++i) {
      power += dot(attracted(*attraction, i, states), states[attraction->from].velocity);
    }
  }
  return power;
}

double Acting::potential(std::span<const BodyState> states) const {
  double potential = 0;
  for (const Force& force : scene_.forces) {
    const auto* constant = std::get_if<Constant>(&force);
    if (constant == nullptr || masses()[constant->body].mass == 0) continue;
    const BodyState& state = states[constant->body];
    potential -= dot(constant->force, state.position) + constant->torque * state.angle;
  }
  return potential;
}

}  // namespace plumb
