#include "scenarios/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb {

Vec path_offset(const Path& path, double t) {
  const double turned = 2 * std::numbers::pi * path.frequency * t;
  return (std::sin(turned + path.phase) - std::sin(path.phase)) * path.amplitude;
}

Vec start_velocity(const Body& body) {
  if (!body.path) return body.velocity;
  const double rate = 2 * std::numbers::pi * body.path->frequency * std::cos(body.path->phase);
  return body.velocity + rate * body.path->amplitude;
}

bool is_carried(const Body& body) {
  return body.type == BodyType::kinematic && (body.path || body.velocity != Vec{} || body.angular_velocity != 0);
}

bool has_paths(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.path.has_value(); });
}

}  // namespace plumb
