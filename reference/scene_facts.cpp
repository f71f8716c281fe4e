#include "reference/scene_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

Vec minus(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }

struct Moved {
  Vec by;  // taken off every point

  void operator()(Circle& circle) const { circle.center = minus(circle.center, by); }
  void operator()(Box& box) const { box.center = minus(box.center, by); }
  void operator()(Polygon& polygon) const {
    for (Vec& vertex : polygon.vertices) vertex = minus(vertex, by);
  }
  void operator()(Capsule& capsule) const {
    capsule.from = minus(capsule.from, by);
    capsule.to = minus(capsule.to, by);
  }
  void operator()(Segment& segment) const {
    segment.from = minus(segment.from, by);
    segment.to = minus(segment.to, by);
  }
  void operator()(HalfSpace& half_space) const {
    half_space.offset -= half_space.normal.x * by.x + half_space.normal.y * by.y;
  }
};

}  // namespace

double reach(const Scene& scene) {
  const double t = scene.duration;
  const double fall = std::hypot(scene.gravity.x, scene.gravity.y) * t * t / 2;
  double farthest = 100;
  for (const Body& body : scene.bodies) {
    const double start = std::hypot(body.position.x, body.position.y);
    const double flight = std::hypot(body.velocity.x, body.velocity.y) * t + std::abs(body.gravity_scale) * fall;
    farthest = std::max(farthest, start + flight);
  }
  return farthest;
}

double smallest_body(const Scene& scene) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    const Mass of = mass_of(body);
    if (of.inertia > 0) smallest = std::min(smallest, 2 * std::sqrt(2 * of.inertia / of.mass));  // a disc has m r^2/2
  }
  return std::isfinite(smallest) ? smallest : 1;
}

std::string needs_two_frictions(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) {
      if (shape.surface.static_friction != shape.surface.dynamic_friction) {
        return "knows one coefficient of friction; \"" + body.name + "\" sticks and slides with different ones";
      }
    }
  }
  return "";
}

std::string needs_dynamic_half_space(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    for (const Shape& shape : body.shapes) {
      if (std::holds_alternative<HalfSpace>(shape.geometry)) {
        return "knows no half-space that is free to move, as \"" + body.name + "\" is";
      }
    }
  }
  return "";
}

std::string needs_massless_body(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic && mass_of(body).mass == 0) {
      return "moves nothing without mass; \"" + body.name + "\" has none";
    }
  }
  return "";
}

Body centered(const Body& body) {
  const Vec center = mass_of(body).center;
  const double c = std::cos(body.angle);
  const double s = std::sin(body.angle);
  Body moved = body;
  moved.position = {body.position.x + c * center.x - s * center.y, body.position.y + s * center.x + c * center.y};
  for (Shape& shape : moved.shapes) std::visit(Moved{center}, shape.geometry);
  return moved;
}

}  // namespace plumb
