#include "reference/adapter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

std::string two_frictions_refusal(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) {
      if (shape.surface.static_friction != shape.surface.dynamic_friction) {
        return "has one coefficient of friction, but static and dynamic friction of \"" + body.name + "\" differ";
      }
    }
  }
  return "";
}

// A point fixed to a body or to the world.
struct Anchor {
  Vec arm;  // from the centre of mass, world frame
  Vec point;
  Vec velocity;
};

Anchor on_body(const BodyState& body, Vec center, Vec local) {
  const Vec arm = rotated(local - center, body.angle);
  return {arm,
          body.position + arm,
          {body.velocity.x - body.angular_velocity * arm.y, body.velocity.y + body.angular_velocity * arm.x}};
}

void push(Load& load, Vec force, Vec arm) {
  load.force = load.force + force;
  load.torque += cross(arm, force);
}

std::vector<std::pair<std::string, std::string>> on_or_off(const char* on, const char* off) {
  return {{"on", on}, {"off", off}};
}

// Drives kinematic bodies along their paths, for every engine alike.
class OnPaths : public Simulation {
 public:
  OnPaths(const Scene& scene, std::unique_ptr<Simulation> inner) : inner_(std::move(inner)) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      if (!body.path) continue;
      carried_.push_back({i, body.velocity, *body.path});
      inner_->drive(i, start_velocity(body));
    }
  }

  void announce(double dt, std::size_t steps) override { inner_->announce(dt, steps); }

  void step(double dt) override {
    for (const Carried& body : carried_) {
      const Vec from = path_offset(body.path, time_);
      const Vec to = path_offset(body.path, time_ + dt);
      inner_->drive(body.index, {body.steady.x + (to.x - from.x) / dt, body.steady.y + (to.y - from.y) / dt});
    }
    inner_->step(dt);
    time_ += dt;
  }

  void read(std::span<BodyState> out) const override { inner_->read(out); }
  void read_contacts(std::vector<ContactState>& out) const override { inner_->read_contacts(out); }
  std::optional<double> seconds_stepped() const override { return inner_->seconds_stepped(); }
  double valid_until() const override { return inner_->valid_until(); }

 private:
  struct Carried {
    std::size_t index;
    Vec steady;  // m/s, the velocity beside the path's
    Path path;
  };

  std::unique_ptr<Simulation> inner_;
  std::vector<Carried> carried_;
  double time_ = 0;  // s
};

}  // namespace

std::string moving_half_space_refusal(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    for (const Shape& shape : body.shapes) {
      if (std::holds_alternative<HalfSpace>(shape.geometry)) {
        return "cannot move a half-space, as \"" + body.name + "\" would need";
      }
    }
  }
  return "";
}

std::string massless_refusal(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic && mass_of(body).mass == 0) {
      return "cannot move a body without mass, as \"" + body.name + "\" is";
    }
  }
  return "";
}

std::string feature_refusal(const Scene& scene) {
  std::string reason = two_frictions_refusal(scene);
  if (reason.empty()) reason = moving_half_space_refusal(scene);
  if (reason.empty()) reason = massless_refusal(scene);
  return reason;
}

double scene_extent(const Scene& scene) {
  const double t = scene.duration;
  const double fall = std::hypot(scene.gravity.x, scene.gravity.y) * t * t / 2;
  double farthest = 100;
  for (const Body& body : scene.bodies) {
    const double start = length(body.position);
    const double flight = length(body.velocity) * t + std::abs(body.gravity_scale) * fall;
    farthest = std::max(farthest, start + flight);
  }
  return farthest;
}

HalfSpaceEdge edge_of(const Body& body, const HalfSpace& half_space, double extent) {
  return {body.angle + std::atan2(-half_space.normal.x, half_space.normal.y),
          {{extent, half_space.offset}, {-extent, half_space.offset}}};
}

Loads::Loads(const Scene& scene) : forces_(scene.forces), loads_(scene.bodies.size()), states_(scene.bodies.size()) {
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

std::span<const Load> Loads::at(const Simulation& simulation, double ahead) {
  simulation.read(states_);
  if (ahead == 0) return at(states_);
  for (BodyState& state : states_) {
    state.position = state.position + ahead * state.velocity;
    state.angle += ahead * state.angular_velocity;
  }
  return at(states_);
}

// F = m strength / r^exponent towards `from`. Two bodies at the same point have no direction and so no force.
void Loads::add(const Attraction& attraction, std::span<const BodyState> states) {
  const Vec center = states[attraction.from].position;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (i == attraction.from || bodies_[i].mass == 0) continue;
    const Vec d = center - states[i].position;
    const double r = length(d);
    if (r == 0) continue;
    const double f = bodies_[i].mass * attraction.strength / std::pow(r, attraction.exponent);
    const Vec force{f * d.x / r, f * d.y / r};
    push(loads_[i], force, {});
    if (attraction.mutual) push(loads_[attraction.from], -force, {});
  }
}

void Loads::add(const Spring& spring, std::span<const BodyState> states) {
  const Anchor a = spring.a ? on_body(states[*spring.a], bodies_[*spring.a].center, spring.anchor_a)
                            : Anchor{{}, spring.anchor_a, {}};
  const Anchor b = on_body(states[spring.b], bodies_[spring.b].center, spring.anchor_b);
  const Vec d = b.point - a.point;
  const double distance = length(d);
  if (distance == 0) return;
  const Vec u{d.x / distance, d.y / distance};
  const double rate = dot(u, b.velocity - a.velocity);
  const double pull = spring.stiffness * (distance - spring.length) + spring.damping * rate;
  if (spring.a) push(loads_[*spring.a], pull * u, a.arm);
  push(loads_[spring.b], -pull * u, b.arm);
}

void Loads::add(const Constant& constant, std::span<const BodyState>) {
  push(loads_[constant.body], constant.force, {});
  loads_[constant.body].torque += constant.torque;
}

// By way of a floating-point number, since settings may be written as 1e3.
int whole_number(const Settings& settings, const std::string& key) {
  return static_cast<int>(std::stod(settings.at(key)));
}

Option restitution_threshold_option() {
  return {.key = "restitution",
          .value = "1",
          .about = "m/s, closing speed below which nothing bounces",
          .min = 0,
          .max = 100};
}

Option continuous_option() {
  return {.key = "continuous",
          .value = "on",
          .choices = on_or_off("stops bodies at fixed ones within a step", "bodies may overlap after a step"),
          .about = "continuous collision"};
}

Option sleep_option() {
  return {.key = "sleep",
          .value = "off",
          .choices = on_or_off("stops bodies that hardly move", "bodies never sleep"),
          .about = "sleeping"};
}

Option warm_start_option() {
  return {.key = "warm",
          .value = "on",
          .choices = on_or_off("starts from the last step's impulses", "starts from zero"),
          .about = "warm starting"};
}

std::unique_ptr<Simulation> on_paths(const Scene& scene, std::unique_ptr<Simulation> simulation) {
  if (!has_paths(scene)) return simulation;
  return std::make_unique<OnPaths>(scene, std::move(simulation));
}

}  // namespace plumb
