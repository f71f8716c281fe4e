#include "reference/reduced_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/scene_facts.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr double clearance_margin = 1e-3;            // m, between bodies that count as apart: far above round-off
constexpr std::size_t most_bodies_paired = 1 << 10;  // checking every pair of these takes some ms

// A body on a parabola, bounded by the disc about its centre of mass that contains it at any angle.
struct Flight {
  const Body* body;
  BodyState start;
  Vec acceleration;
  double radius;  // m; infinite for a half-space
};

bool can_collide(const Body& a, const Body& b) {
  return (a.layers & b.layers) != 0 && (a.type == BodyType::dynamic || b.type == BodyType::dynamic);
}

bool joined(const Scene& scene, std::size_t a, std::size_t b) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const Joint& joint) {
    return std::visit([&](const auto& kind) { return (kind.a == a && kind.b == b) || (kind.a == b && kind.b == a); },
                      joint);
  });
}

std::vector<std::pair<std::size_t, std::size_t>> colliding_pairs(const Scene& scene) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    if (scene.bodies[a].shapes.empty()) continue;
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      if (scene.bodies[b].shapes.empty() || !can_collide(scene.bodies[a], scene.bodies[b])) continue;
      if (!joined(scene, a, b)) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

bool has_half_space(const Body& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(),
                     [](const Shape& shape) { return std::holds_alternative<HalfSpace>(shape.geometry); });
}

Flight flight_of(const Scene& scene, std::size_t i) {
  const Body& body = scene.bodies[i];
  Flight flight{&body, start_of(body), gravity_of(scene, body), bounding_radius(body)};
  if (has_half_space(body)) flight.radius = std::numeric_limits<double>::infinity();
  if (body.path) flight.radius += 2 * length(body.path->amplitude);
  for (const Force& force : scene.forces) {
    const auto* constant = std::get_if<Constant>(&force);
    if (constant != nullptr && constant->body == i) {
      flight.acceleration = flight.acceleration + (1 / mass_of(body).mass) * constant->force;
    }
  }
  return flight;
}

// Least and largest value of x + v t + a t^2/2 over 0 ... duration.
std::pair<double, double> range(double x, double v, double a, double duration) {
  const auto at = [=](double t) { return x + t * (v + a * t / 2); };
  auto [low, high] = std::minmax({at(0), at(duration)});
  const double vertex = a == 0 ? -1 : -v / a;
  if (vertex > 0 && vertex < duration) {
    low = std::min(low, at(vertex));
    high = std::max(high, at(vertex));
  }
  return {low, high};
}

double distance_to_zero(std::pair<double, double> range) { return std::max({range.first, -range.second, 0.0}); }

// Lower bound on the distance of the two centres, m. Exact for uniform relative motion; for a parabola it is the
// distance to the box around the parabola.
double least_distance(const Flight& a, const Flight& b, double duration) {
  const Vec r = b.start.position - a.start.position;
  const Vec v = b.start.velocity - a.start.velocity;
  const Vec acceleration = b.acceleration - a.acceleration;
  if (acceleration == Vec{}) {
    const double speed = dot(v, v);
    const double t = speed > 0 ? std::clamp(-dot(r, v) / speed, 0.0, duration) : 0;
    return length(r + t * v);
  }
  return std::hypot(distance_to_zero(range(r.x, v.x, acceleration.x, duration)),
                    distance_to_zero(range(r.y, v.y, acceleration.y, duration)));
}

bool stays_above(const Flight& flight, const Body& ground, double duration) {
  return std::all_of(ground.shapes.begin(), ground.shapes.end(), [&](const Shape& shape) {
    const auto* half = std::get_if<HalfSpace>(&shape.geometry);
    if (half == nullptr || ground.type != BodyType::fixed) return false;
    const Vec n = rotated(half->normal, ground.angle);
    const double height = dot(n, flight.start.position - ground.position) - half->offset;
    return range(height, dot(n, flight.start.velocity), dot(n, flight.acceleration), duration).first >
           flight.radius + clearance_margin;
  });
}

bool never_meet(const Scene& scene, const Flight& a, const Flight& b) {
  if (std::isinf(a.radius)) return !std::isinf(b.radius) && stays_above(b, *a.body, scene.duration);
  if (std::isinf(b.radius)) return stays_above(a, *b.body, scene.duration);
  return least_distance(a, b, scene.duration) > a.radius + b.radius + clearance_margin;
}

// Whether nothing but gravity and constant forces acts.
bool all_parabolas(const Scene& scene) {
  const bool constant = std::all_of(scene.forces.begin(), scene.forces.end(),
                                    [](const Force& force) { return std::holds_alternative<Constant>(force); });
  return constant && scene.joints.empty() &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.linear_damping == 0 && body.angular_damping == 0; });
}

// What the rules below decide by.
struct SceneTraits {
  const Scene& scene;
  std::string none_meet;  // why no two bodies touch; "" if some might
  bool frictionless = false;
  bool inelastic = false;
};

struct RedundancyRule {
  const char* option;
  const char* value;                       // that switches the feature off
  std::string (*why)(const SceneTraits&);  // "" if the scene needs the feature
};

// Whether the mixed coefficient is zero for every two surfaces of the scene.
template <class Coefficient>
bool is_zero(const Scene& scene, Coefficient coefficient) {
  std::vector<Surface> seen;
  const auto zero = [&](const Surface& a, const Surface& b) { return coefficient(scene.mixing, a, b) == 0; };
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) {
      const Surface& one = shape.surface;
      const bool known = std::any_of(seen.begin(), seen.end(), [&](const Surface& other) {
        return one.static_friction == other.static_friction && one.dynamic_friction == other.dynamic_friction &&
               one.restitution == other.restitution;
      });
      if (known) continue;
      seen.push_back(one);
      if (!std::all_of(seen.begin(), seen.end(), [&](const Surface& other) { return zero(one, other); })) return false;
    }
  }
  return true;
}

// Whether a force may exert a torque about a centre of mass.
struct MayExertTorque {
  const Scene& scene;

  bool acts_at_center(std::size_t body, Vec anchor) const {
    return scene.bodies[body].type != BodyType::dynamic || anchor == mass_of(scene.bodies[body]).center;
  }
  bool operator()(const Attraction&) const { return false; }
  bool operator()(const Constant& constant) const { return constant.torque != 0; }
  bool operator()(const Spring& spring) const {
    return !acts_at_center(spring.b, spring.anchor_b) || (spring.a && !acts_at_center(*spring.a, spring.anchor_a));
  }
};

// A contact force on such a body acts through its centre if there is no friction.
bool is_centered_disc(const Body& body) {
  const Circle* circle = only_shape<Circle>(body);
  return circle != nullptr && circle->center == Vec{};
}

std::string why_none_rotates(const SceneTraits& traits) {
  const Scene& scene = traits.scene;
  if (!scene.joints.empty()) return "";
  if (std::any_of(scene.forces.begin(), scene.forces.end(),
                  [&](const Force& force) { return std::visit(MayExertTorque{scene}, force); })) {
    return "";
  }
  for (const Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    if (body.angular_velocity != 0) return "";
    if (traits.none_meet.empty() && !(traits.frictionless && is_centered_disc(body))) return "";
  }
  return traits.none_meet.empty()
             ? "no body rotates at the start, and every force on a frictionless disc acts through its centre"
             : "no body rotates at the start, and every force acts at a centre of mass";
}

// No rule for precision: how fast round-off grows depends on the step. None for sleeping or coarser steps: the scene
// does not show in advance that a body will come to rest, or how much an error matters.
constexpr std::array rules{
    RedundancyRule{"contacts", "off", [](const SceneTraits& traits) { return traits.none_meet; }},
    RedundancyRule{"continuous", "off",
                   [](const SceneTraits& traits) -> std::string {
                     return traits.none_meet.empty() ? "" : "bodies that never meet cannot tunnel through each other";
                   }},
    RedundancyRule{"rotation", "off", why_none_rotates},
    RedundancyRule{"friction", "off",
                   [](const SceneTraits& traits) -> std::string {
                     return traits.frictionless ? "every mixed coefficient of friction is 0" : "";
                   }},
    RedundancyRule{"restitution", "off",
                   [](const SceneTraits& traits) -> std::string {
                     return traits.inelastic ? "every mixed restitution is 0" : "";
                   }},
};

}  // namespace

std::vector<Option> reductions() {
  return {{.key = "rotation",
           .value = "on",
           .choices = {{"on", "bodies rotate"},
                       {"off", "no dynamic body rotates, as if its moment of inertia were infinite"}},
           .about = "whether bodies rotate"},
          {.key = "friction",
           .value = "full",
           .choices = {{"full", "static and dynamic friction, as in the scene"},
                       {"dynamic", "a sticking contact holds no better than a sliding one"},
                       {"off", "no friction"}},
           .about = "friction of contacts"},
          {.key = "restitution",
           .value = "on",
           .choices = {{"on", "as in the scene"}, {"off", "nothing bounces"}},
           .about = "restitution of contacts"}};
}

Scene reduced(Scene scene, const Settings& settings) {
  const bool rotates = settings.at("rotation") == "on";
  const std::string& friction = settings.at("friction");
  const bool bounces = settings.at("restitution") == "on";
  for (Body& body : scene.bodies) {
    if (!rotates && body.type == BodyType::dynamic) {
      body.fixed_rotation = true;
      body.angular_velocity = 0;
    }
    for (Shape& shape : body.shapes) {
      Surface& surface = shape.surface;
      if (friction != "full") surface.static_friction = surface.dynamic_friction;
      if (friction == "off") surface.static_friction = surface.dynamic_friction = 0;
      if (!bounces) surface.restitution = 0;
    }
  }
  return scene;
}

std::vector<Choice> redundant_features(const Scene& scene) {
  SceneTraits traits{.scene = scene, .none_meet = why_none_meet(scene)};
  traits.frictionless = is_zero(scene, mixed_static_friction);
  traits.inelastic = is_zero(scene, mixed_restitution);
  std::vector<Choice> choices;
  for (const RedundancyRule& rule : rules) {
    if (const std::string why = rule.why(traits); !why.empty()) choices.push_back({rule.option, rule.value, why});
  }
  return choices;
}

std::string why_none_meet(const Scene& scene) {
  if (scene.bodies.size() > most_bodies_paired) return "";
  const auto pairs = colliding_pairs(scene);
  if (pairs.empty()) return "no two bodies share a layer, except pairs connected by a joint";
  if (!all_parabolas(scene)) return "";
  std::vector<Flight> flights;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) flights.push_back(flight_of(scene, i));
  const bool none = std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return never_meet(scene, flights[pair.first], flights[pair.second]);
  });
  return none ? "all bodies are in free flight, and no two come within contact distance before the scene ends" : "";
}

}  // namespace plumb
