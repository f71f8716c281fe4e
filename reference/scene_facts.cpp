#include "reference/scene_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/scene/mass.h"
#include "scenarios/scene/shapes.h"
#include "scenarios/scene/vec.h"

namespace plumb {

BodyState start_of(const Body& body) {
  return {.position = body.position + rotated(mass_of(body).center, body.angle),
          .angle = body.angle,
          .velocity = start_velocity(body),
          .angular_velocity = body.angular_velocity};
}

std::vector<BodyState> start_of(const Scene& scene) {
  std::vector<BodyState> states;
  for (const Body& body : scene.bodies) states.push_back(start_of(body));
  return states;
}

Vec gravity_of(const Scene& scene, const Body& body) {
  return body.type == BodyType::dynamic ? body.gravity_scale * scene.gravity : Vec{};
}

Body centered(const Body& body) {
  const Vec center = mass_of(body).center;
  const double c = std::cos(body.angle);
  const double s = std::sin(body.angle);
  Body moved = body;
  moved.position = {body.position.x + c * center.x - s * center.y, body.position.y + s * center.x + c * center.y};
  for (Shape& shape : moved.shapes) shape.geometry = mapped(shape.geometry, FrameMap{.origin = center});
  return moved;
}

double bounding_radius(const Body& body) {
  double radius = 0;
  const Vec center = mass_of(body).center;
  for (const Shape& shape : body.shapes) {
    const Outline outline = outline_of(shape.geometry, center);
    for (const Vec point : outline.points) radius = std::max(radius, length(point) + outline.radius);
  }
  return radius;
}

double smallest_body(const Scene& scene) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    const Mass mass = mass_of(body);
    // A disc of radius r has I = m r^2/2.
    if (mass.inertia > 0) smallest = std::min(smallest, 2 * std::sqrt(2 * mass.inertia / mass.mass));
  }
  return std::isfinite(smallest) ? smallest : 1;
}

}  // namespace plumb
