#include "scenarios/images.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "scenarios/random.h"
#include "scenarios/scene/forces.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/shapes.h"

namespace plumb {
namespace {

// Gives every body that a joint or a force acts on another index.
void renumber(Scene& scene, const std::function<std::size_t(std::size_t)>& index) {
  for (Joint& joint : scene.joints) {
    std::visit([&](auto& kind) { kind.a = index(kind.a), kind.b = index(kind.b); }, joint);
  }
  for (Force& force : scene.forces) force = renumbered(force, index);
}

}  // namespace

Scene mapped(const Scene& scene, const Congruence& map) {
  Scene image = scene;
  image.gravity = map.of_vector(scene.gravity);
  for (Body& body : image.bodies) {
    body.position = map.of_point(body.position);
    body.angle = map.of_angle(body.angle);
    body.velocity = map.of_vector(body.velocity);
    body.angular_velocity = map.of_spin(body.angular_velocity);
    if (body.path) body.path->amplitude = map.of_vector(body.path->amplitude);
    if (!map.mirrored) continue;
    for (Shape& shape : body.shapes) shape.geometry = mapped(shape.geometry, FrameMap{.mirrored = true});
  }
  for (Joint& joint : image.joints) joint = mapped(joint, map);
  for (Force& force : image.forces) force = mapped(force, map);
  return image;
}

Scene in_units(const Scene& scene, const Units& units) {
  Scene image = scene;
  image.duration *= units.time;
  image.gravity = units.acceleration() * scene.gravity;
  for (Body& body : image.bodies) {
    body.position = units.length * body.position;
    body.velocity = units.speed() * body.velocity;
    body.angular_velocity /= units.time;
    body.linear_damping /= units.time;
    body.angular_damping /= units.time;
    if (body.path) {
      body.path->amplitude = units.length * body.path->amplitude;
      body.path->frequency /= units.time;
    }
    for (Shape& shape : body.shapes) {
      shape.geometry = mapped(shape.geometry, FrameMap{.factor = units.length});
      shape.surface.density *= units.mass / (units.length * units.length);
    }
  }
  for (Joint& joint : image.joints) joint = in_units(joint, units);
  for (Force& force : image.forces) force = in_units(force, units);
  return image;
}

Scene boosted(const Scene& scene, Vec u) {
  Scene image = scene;
  for (Body& body : image.bodies) {
    if (body.type == BodyType::fixed) {
      body.type = BodyType::kinematic;
      body.velocity = {};
      body.angular_velocity = 0;
    }
    body.velocity = body.velocity + u;
  }
  return image;
}

Scene listed_backwards(const Scene& scene) {
  Scene image = scene;
  renumber(image, [last = scene.bodies.size() - 1](std::size_t i) { return last - i; });
  std::reverse(image.bodies.begin(), image.bodies.end());
  for (Body& body : image.bodies) std::reverse(body.shapes.begin(), body.shapes.end());
  std::reverse(image.joints.begin(), image.joints.end());
  std::reverse(image.forces.begin(), image.forces.end());
  return image;
}

Scene doubled(const Scene& scene, Vec shift, std::uint32_t layers, int apart) {
  Scene copy = mapped(scene, {.shift = shift});
  renumber(copy, [n = scene.bodies.size()](std::size_t i) { return n + i; });
  Scene both = scene;
  for (Body& body : both.bodies) body.layers &= layers;
  for (Body& body : copy.bodies) {
    body.name += " (copy)";
    body.layers = (body.layers & layers) << apart;
  }
  both.bodies.insert(both.bodies.end(), copy.bodies.begin(), copy.bodies.end());
  both.joints.insert(both.joints.end(), copy.joints.begin(), copy.joints.end());
  both.forces.insert(both.forces.end(), copy.forces.begin(), copy.forces.end());
  return both;
}

Scene perturbed(const Scene& scene, double size, std::uint64_t seed) {
  Random random(seed);
  Scene moved = scene;
  for (Body& body : moved.bodies) {
    if (body.type != BodyType::dynamic) continue;
    body.position.x += random.between(-size, size);
    body.position.y += random.between(-size, size);
  }
  return moved;
}

double extent_of(const Scene& scene) {
  Vec low, high;
  double size = 0;
  bool any = false;
  for (const Body& body : scene.bodies) {
    const Mass mass = mass_of(body);
    if (body.type != BodyType::dynamic) continue;
    if (mass.mass > 0 && mass.inertia > 0) size = std::max(size, std::sqrt(mass.inertia / mass.mass));
    low = any ? Vec{std::min(low.x, body.position.x), std::min(low.y, body.position.y)} : body.position;
    high = any ? Vec{std::max(high.x, body.position.x), std::max(high.y, body.position.y)} : body.position;
    any = true;
  }
  const double apart = length(high - low) / 2 + size;
  return apart > 0 ? apart : 1;
}

}  // namespace plumb
