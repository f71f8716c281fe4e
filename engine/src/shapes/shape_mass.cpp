#include <cmath>
#include <stdexcept>
#include <string>

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// m r^2 / 2. (The author's demo has m r^2, which is a hoop's.)
MassData disc_mass(const Shape& shape, Real density) {
  const Real r = shape.radius();
  const Real mass = density * pi * r * r;
  return {mass, mass * r * r / 2, shape.centroid()};
}

MassData rectangle_mass(const Shape& shape, Real density) {
  const Vec2 h = shape.half_extents();
  const Real mass = density * 4 * h.x * h.y;
  return {mass, mass * (h.x * h.x + h.y * h.y) / 3, shape.centroid()};
}

// The sum of the triangles that the centroid makes with the edges: one with sides a and b from there has the second
// moment cross(a, b) (a.a + a.b + b.b) / 12.
MassData polygon_mass(const Shape& shape, Real density) {
  Real doubled_area = 0;
  Real moment = 0;
  for (int i = 0; i < shape.count(); ++i) {
    const Vec2 a = shape.vertex(i) - shape.centroid();
    const Vec2 b = shape.vertex((i + 1) % shape.count()) - shape.centroid();
    const Real doubled = cross(a, b);
    doubled_area += doubled;
    moment += doubled * (dot(a, a) + dot(a, b) + dot(b, b)) / 12;
  }
  return {density * doubled_area / 2, density * moment, shape.centroid()};
}

// A rectangle of length l between two half discs. A half disc's own centre lies k = 4r/(3 pi) out from its flat side,
// so about the capsule's centre each has m (r^2/2 - k^2 + (l/2 + k)^2) = m (r^2/2 + l^2/4 + l k).
MassData capsule_mass(const Shape& shape, Real density) {
  const Real r = shape.radius();
  const Real l = length(shape.vertex(1) - shape.vertex(0));
  const Real middle = density * 2 * r * l;
  const Real caps = density * pi * r * r;
  const Real k = 4 * r / (3 * pi);
  const Real inertia = middle * (l * l + 4 * r * r) / 12 + caps * (r * r / 2 + l * l / 4 + l * k);
  return {middle + caps, inertia, shape.centroid()};
}

}  // namespace

MassData Shape::mass(Real density) const {
  if (!(density >= 0) || !std::isfinite(density)) {
    throw std::invalid_argument("a density must be finite and not negative, not " + std::to_string(density));
  }
  switch (type_) {
    case ShapeType::circle:
      return disc_mass(*this, density);
    case ShapeType::box:
      return rectangle_mass(*this, density);
    case ShapeType::polygon:
      return polygon_mass(*this, density);
    case ShapeType::capsule:
      return capsule_mass(*this, density);
    case ShapeType::segment:
    case ShapeType::half_space:
      break;
  }
  return {0, 0, centroid_};
}

}  // namespace impulse::inline IMPULSE_PRECISION
