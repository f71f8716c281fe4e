#include <cmath>
#include <vector>

#include "reports/find/shrink.h"
#include "scenarios/catalog.h"

namespace plumb::cuts::values {
namespace {

using Change = void (*)(Body&);

void no_friction(Body& body) {
  for (Shape& shape : body.shapes) shape.surface.static_friction = shape.surface.dynamic_friction = 0;
}
void full_friction(Body& body) {
  for (Shape& shape : body.shapes) {
    if (shape.surface.static_friction != 0) shape.surface.static_friction = shape.surface.dynamic_friction = 1;
  }
}
void no_restitution(Body& body) {
  for (Shape& shape : body.shapes) shape.surface.restitution = 0;
}
void full_restitution(Body& body) {
  for (Shape& shape : body.shapes) {
    if (shape.surface.restitution != 0) shape.surface.restitution = 1;
  }
}
void unit_density(Body& body) {
  for (Shape& shape : body.shapes) shape.surface.density = 1;
}
void no_damping(Body& body) { body.linear_damping = body.angular_damping = 0; }
void plain(Body& body) {
  body.gravity_scale = 1;
  body.fixed_rotation = body.bullet = false;
}
void no_path(Body& body) { body.path.reset(); }
void any_layer(Body& body) { body.layers = Body{}.layers; }
void no_spin(Body& body) { body.angular_velocity = 0; }
void no_velocity(Body& body) { body.velocity = {}; }
void level(Body& body) { body.angle = 0; }
void straight(Body& body) {
  const Vec v = body.velocity;
  body.velocity = std::abs(v.x) > std::abs(v.y) ? Vec{v.x, 0} : Vec{0, v.y};
}

constexpr Change changes[] = {no_damping,     plain,         no_path,         any_layer,   no_friction,
                              no_restitution, unit_density,  no_spin,         no_velocity, straight,
                              level,          full_friction, full_restitution};

// Each change to all bodies at once, then to each.
std::vector<Scene> simpler_values(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  for (const Vec gravity : {Vec{0, -standard_gravity}, Vec{}}) {
    if (scene.gravity == gravity || scene.gravity == Vec{}) continue;
    all.push_back(scene);
    all.back().gravity = gravity;
  }
  all.push_back(scene);
  all.back().mixing = {};
  for (const Change change : changes) {
    all.push_back(scene);
    for (Body& body : all.back().bodies) change(body);
  }
  for (std::size_t i = 0; i < scene.bodies.size() && scene.bodies.size() > 1; ++i) {
    for (const Change change : changes) {
      all.push_back(scene);
      change(all.back().bodies[i]);
    }
  }
  return all;
}

const Catalog<Cut>::Entry entry{{.name = "plain values", .order = 5, .simpler = simpler_values}};

}  // namespace
}  // namespace plumb::cuts::values
