#include "impulse/shape.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

void require_finite(Vec2 v, const char* what) {
  if (!is_finite(v)) throw std::invalid_argument(std::string(what) + " must be finite");
}

void require_positive(Real size, const char* what) {
  if (!(size > 0) || !is_finite(size)) {
    throw std::invalid_argument(std::string(what) + " must be positive and finite, not " + std::to_string(size));
  }
}

void require_apart(Vec2 from, Vec2 to, const char* what) {
  require_finite(from, what);
  require_finite(to, what);
  if (!(length(to - from) > 0)) throw std::invalid_argument(std::string(what) + " must have two distinct ends");
}

// Area-weighted mean of the triangles at vertex 0. Uses offsets from it, to be as precise far from the origin as near.
Vec2 centroid_of(std::span<const Vec2> vertices) {
  const Vec2 origin = vertices[0];
  Vec2 weighted;
  Real doubled_area = 0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    const Vec2 a = vertices[i] - origin;
    const Vec2 b = vertices[i + 1] - origin;
    const Real doubled = cross(a, b);
    weighted += doubled * (a + b);
    doubled_area += doubled;
  }
  return origin + weighted / (3 * doubled_area);
}

// m r^2 / 2. (The demo of the article's author has m r^2, which is the inertia of a hoop.)
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

// The sum over the triangles that the centroid makes with the edges: a triangle with sides a and b from the centroid
// has the second moment cross(a, b) (a.a + a.b + b.b) / 12.
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

// A rectangle of length l between two half discs. The centre of a half disc lies k = 4r/(3 pi) out from its flat side,
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

Shape Shape::hull(ShapeType type, std::span<const Vec2> vertices, Real radius) {
  Shape shape;
  shape.type_ = type;
  shape.count_ = static_cast<std::uint8_t>(vertices.size());
  shape.radius_ = radius;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    shape.vertices_[i] = vertices[i];
    shape.normals_[i] = -perpendicular(normalized(vertices[(i + 1) % vertices.size()] - vertices[i]));
  }
  return shape;
}

Shape Shape::circle(Real radius, Vec2 center) {
  require_positive(radius, "the radius of a circle");
  require_finite(center, "the center of a circle");
  Shape shape = hull(ShapeType::circle, {&center, 1}, radius);
  shape.centroid_ = center;
  return shape;
}

Shape Shape::box(Vec2 half_extents, Vec2 center, Real angle) {
  require_positive(half_extents.x, "the half width of a box");
  require_positive(half_extents.y, "the half height of a box");
  require_finite(center, "the center of a box");
  if (!is_finite(angle)) throw std::invalid_argument("the angle of a box must be finite");
  const Rotation q(angle);
  const Vec2 x = q * Vec2{half_extents.x, 0};
  const Vec2 y = q * Vec2{0, half_extents.y};
  const std::array vertices{center - x - y, center + x - y, center + x + y, center - x + y};
  Shape shape = hull(ShapeType::box, vertices, 0);
  // From the angle itself, which is more precise than differences of vertices far from the origin.
  shape.normals_ = {Vec2{q.s, -q.c}, Vec2{q.c, q.s}, Vec2{-q.s, q.c}, Vec2{-q.c, -q.s}};
  shape.half_extents_ = half_extents;
  shape.centroid_ = center;
  return shape;
}

Shape Shape::polygon(std::span<const Vec2> points) {
  for (const Vec2 p : points) require_finite(p, "the vertices of a polygon");
  const std::vector<Vec2> vertices = convex_hull(points);
  if (vertices.size() < 3) throw std::invalid_argument("a polygon needs three points that are not on one line");
  if (vertices.size() > max_vertices) {
    throw std::invalid_argument("the convex hull of a polygon has " + std::to_string(vertices.size()) +
                                " vertices; at most 8 are possible");
  }
  constexpr Real thinnest = static_cast<Real>(1e-3);  // below this, rounding would dominate its normals and centroid
  if (width(vertices) < thinnest * diameter(vertices)) {
    throw std::invalid_argument("a polygon must not be thinner than a thousandth of its length; use a segment");
  }
  Shape shape = hull(ShapeType::polygon, vertices, 0);
  shape.centroid_ = centroid_of(vertices);
  return shape;
}

Shape Shape::capsule(Vec2 from, Vec2 to, Real radius) {
  require_positive(radius, "the radius of a capsule");
  require_apart(from, to, "a capsule");
  Shape shape = hull(ShapeType::capsule, std::array{from, to}, radius);
  shape.centroid_ = (from + to) / 2;
  return shape;
}

Shape Shape::segment(Vec2 from, Vec2 to) {
  require_apart(from, to, "a segment");
  Shape shape = hull(ShapeType::segment, std::array{from, to}, 0);
  shape.centroid_ = (from + to) / 2;
  return shape;
}

Shape Shape::half_space(Vec2 normal, Real offset) {
  require_finite(normal, "the normal of a half-space");
  const Real scale = length(normal);
  require_positive(scale, "the length of a half-space's normal");
  if (!is_finite(offset)) throw std::invalid_argument("the offset of a half-space must be finite");
  Shape shape;
  shape.type_ = ShapeType::half_space;
  shape.count_ = 0;
  shape.normals_[0] = normal / scale;
  shape.offset_ = offset / scale;
  shape.given_normal_ = normal;
  shape.given_offset_ = offset;
  shape.centroid_ = shape.offset_ * shape.normals_[0];
  return shape;
}

std::vector<Shape> Shape::chain(std::span<const Vec2> points, bool loop) {
  const std::size_t n = points.size();
  if (n < (loop ? 3U : 2U)) throw std::invalid_argument("a chain needs two points, a loop three");
  const std::size_t count = loop ? n : n - 1;
  std::vector<Shape> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 from = points[i];
    const Vec2 to = points[(i + 1) % n];
    Shape shape = segment(from, to);
    shape.in_chain_ = true;
    shape.ghosts_[0] = loop || i > 0 ? points[(i + n - 1) % n] : to;
    shape.ghosts_[1] = loop || i + 1 < count ? points[(i + 2) % n] : from;
    segments.push_back(shape);
  }
  return segments;
}

Aabb Shape::bounds(const Pose& pose) const {
  if (type_ == ShapeType::box) {
    return box_bounds(to_world(pose, centroid_), pose.q * Rotation(normals_[1].x, normals_[1].y), half_extents_);
  }
  if (type_ == ShapeType::half_space) {
    const Vec2 n = pose.q * normals_[0];
    const Real limit = offset_ + dot(n, pose.p);
    Aabb box{{-unbounded, -unbounded}, {unbounded, unbounded}};
    // The limit in x is least strict where y is at its bound, and the other way round.
    if (n.x > 0) box.high.x = std::min(unbounded, (limit + std::abs(n.y) * unbounded) / n.x);
    if (n.x < 0) box.low.x = std::max(-unbounded, (limit + std::abs(n.y) * unbounded) / n.x);
    if (n.y > 0) box.high.y = std::min(unbounded, (limit + std::abs(n.x) * unbounded) / n.y);
    if (n.y < 0) box.low.y = std::max(-unbounded, (limit + std::abs(n.x) * unbounded) / n.y);
    return box;
  }
  const Vec2 first = to_world(pose, vertices_[0]);
  Aabb box{first, first};
  for (int i = 1; i < count_; ++i) {
    const Vec2 v = to_world(pose, vertex(i));
    box = {min(box.low, v), max(box.high, v)};
  }
  return grown(box, radius_);
}

MassData Shape::mass(Real density) const {
  if (!(density >= 0) || !is_finite(density)) {
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

bool Shape::contains(Vec2 local) const {
  switch (type_) {
    case ShapeType::circle:
      return length_squared(local - centroid_) <= radius_ * radius_;
    case ShapeType::half_space:
      return dot(given_normal_, local) <= given_offset_;
    case ShapeType::segment:
      return false;
    case ShapeType::capsule: {
      const Vec2 axis = vertices_[1] - vertices_[0];
      const Real along = clamp(dot(local - vertices_[0], axis) / length_squared(axis), 0, 1);
      return length_squared(local - (vertices_[0] + along * axis)) <= radius_ * radius_;
    }
    case ShapeType::box:
    case ShapeType::polygon:
      break;
  }
  for (int i = 0; i < count_; ++i) {
    if (dot(normal(i), local - vertex(i)) > 0) return false;
  }
  return true;
}

Real Shape::extent() const {
  if (type_ == ShapeType::half_space) return unbounded;
  Real farthest = 0;
  for (int i = 0; i < count_; ++i) farthest = std::max(farthest, length(vertex(i)));
  return farthest + radius_;
}

Shape Shape::moved(Vec2 by) const {
  Shape shape = *this;
  shape.centroid_ += by;
  shape.offset_ += dot(normals_[0], by);
  shape.given_offset_ += dot(given_normal_, by);
  for (int i = 0; i < count_; ++i) shape.vertices_[static_cast<std::size_t>(i)] += by;
  for (Vec2& ghost : shape.ghosts_) ghost += by;
  return shape;
}

}  // namespace impulse::inline IMPULSE_PRECISION
