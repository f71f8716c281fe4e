#include "reference/loads.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

// A point fixed to a body, or to the world.
struct Anchor {
  Vec arm;  // from the centre of mass, world frame
  Vec point;
  Vec velocity;
};

Anchor on_body(const BodyState& body, Vec center, Vec local) {
  const double c = std::cos(body.angle);
  const double s = std::sin(body.angle);
  const Vec r{local.x - center.x, local.y - center.y};
  const Vec arm{c * r.x - s * r.y, s * r.x + c * r.y};
  return {arm,
          {body.position.x + arm.x, body.position.y + arm.y},
          {body.velocity.x - body.angular_velocity * arm.y, body.velocity.y + body.angular_velocity * arm.x}};
}

void push(Load& load, Vec force, Vec arm) {
  load.force.x += force.x;
  load.force.y += force.y;
  load.torque += arm.x * force.y - arm.y * force.x;
}

}  // namespace

Loads::Loads(const Scene& scene) : forces_(scene.forces), loads_(scene.bodies.size()) {
  for (const Body& body : scene.bodies) {
    const Mass mass = mass_of(body);
    bodies_.push_back({mass.mass, mass.center});
  }
}

std::span<const Load> Loads::at(std::span<const BodyState> states) {
  std::fill(loads_.begin(), loads_.end(), Load{});
  for (const Force& force : forces_) {
    std::visit([&](const auto& kind) { add(kind, states); }, force);
  }
  return loads_;
}

// F = m strength / r^exponent towards `from`; two bodies at one place have no direction and no force.
void Loads::add(const Attraction& attraction, std::span<const BodyState> states) {
  const Vec center = states[attraction.from].position;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (i == attraction.from || bodies_[i].mass == 0) continue;
    const Vec d{center.x - states[i].position.x, center.y - states[i].position.y};
    const double r = std::hypot(d.x, d.y);
    if (r == 0) continue;
    const double f = bodies_[i].mass * attraction.strength / std::pow(r, attraction.exponent);
    const Vec force{f * d.x / r, f * d.y / r};
    push(loads_[i], force, {});
    if (attraction.mutual) push(loads_[attraction.from], {-force.x, -force.y}, {});
  }
}

void Loads::add(const Spring& spring, std::span<const BodyState> states) {
  const Anchor a = spring.a ? on_body(states[*spring.a], bodies_[*spring.a].center, spring.anchor_a)
                            : Anchor{{}, spring.anchor_a, {}};
  const Anchor b = on_body(states[spring.b], bodies_[spring.b].center, spring.anchor_b);
  const Vec d{b.point.x - a.point.x, b.point.y - a.point.y};
  const double distance = std::hypot(d.x, d.y);
  if (distance == 0) return;
  const Vec u{d.x / distance, d.y / distance};
  const double rate = u.x * (b.velocity.x - a.velocity.x) + u.y * (b.velocity.y - a.velocity.y);
  const double pull = spring.stiffness * (distance - spring.length) + spring.damping * rate;
  if (spring.a) push(loads_[*spring.a], {pull * u.x, pull * u.y}, a.arm);
  push(loads_[spring.b], {-pull * u.x, -pull * u.y}, b.arm);
}

void Loads::add(const Constant& constant, std::span<const BodyState>) {
  push(loads_[constant.body], constant.force, {});
  loads_[constant.body].torque += constant.torque;
}

}  // namespace plumb
