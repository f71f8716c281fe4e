#include "reports/judge/outline.h"

#include <algorithm>
#include <limits>

#include "reports/vec.h"

namespace plumb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Outline hull_of(const Circle& circle) { return {.points = {circle.center}, .radius = circle.radius}; }

Outline hull_of(const Box& box) {
  Outline outline;
  for (const Vec corner : {Vec{-1, -1}, Vec{1, -1}, Vec{1, 1}, Vec{-1, 1}}) {
    const Vec half{corner.x * box.size.x / 2, corner.y * box.size.y / 2};
    outline.points.push_back(box.center + rotated(half, box.angle));
  }
  return outline;
}

Outline hull_of(const Polygon& polygon) { return {.points = polygon.vertices}; }
Outline hull_of(const Capsule& capsule) { return {.points = {capsule.from, capsule.to}, .radius = capsule.radius}; }
Outline hull_of(const Segment& segment) { return {.points = {segment.from, segment.to}}; }
Outline hull_of(const HalfSpace& halfspace) { return {.halfspace = halfspace}; }

Interval along(Vec direction, std::span<const Vec> points) {
  Interval range{infinity, -infinity};
  for (const Vec point : points) {
    const double d = dot(direction, point);
    range = {std::min(range.low, d), std::max(range.high, d)};
  }
  return range;
}

// The largest gap between the two hulls' shadows on the normals of a's edges, either way round. A segment casts its
// shadow along itself too: a point beside its end is not in it.
double gap_along_normals(std::span<const Vec> a, std::span<const Vec> b) {
  double largest = -infinity;
  const auto look_along = [&](Vec axis) {
    const Interval of_a = along(axis, a);
    const Interval of_b = along(axis, b);
    largest = std::max({largest, of_b.low - of_a.high, of_a.low - of_b.high});
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec edge = a[(i + 1) % a.size()] - a[i];
    const double size = length(edge);
    if (size == 0) continue;
    look_along({edge.y / size, -edge.x / size});
    if (a.size() == 2) look_along({edge.x / size, edge.y / size});
  }
  return largest;
}

double distance(Vec point, Vec from, Vec to) {
  const Vec edge = to - from;
  const double square = dot(edge, edge);
  const double share = square == 0 ? 0 : std::clamp(dot(point - from, edge) / square, 0.0, 1.0);
  return length(point - from - share * edge);
}

// The nearest points of two hulls that don't meet: one of them is a corner.
double distance(std::span<const Vec> a, std::span<const Vec> b) {
  double nearest = infinity;
  for (const Vec point : a) {
    for (std::size_t i = 0; i < b.size(); ++i)
      nearest = std::min(nearest, distance(point, b[i], b[(i + 1) % b.size()]));
  }
  return nearest;
}

double gap_to(const HalfSpace& context, const Outline& outline) {
  return along(context.normal, outline.points).low - outline.radius - context.offset;
}

}  // namespace

Outline outline_of(const Geometry& geometry, Vec origin) {
  const Outline outline = std::visit([](const auto& shape) { return hull_of(shape); }, geometry);
  return placed(outline, Vec{-origin.x, -origin.y}, 0);
}

Outline placed(const Outline& outline, Vec position, double angle) {
  Outline there = outline;
  for (Vec& point : there.points) point = position + rotated(point, angle);
  if (there.halfspace) {
    there.halfspace->normal = rotated(outline.halfspace->normal, angle);
    there.halfspace->offset += dot(there.halfspace->normal, position);
  }
  return there;
}

std::optional<Interval> range_along(Vec direction, const Outline& outline) {
  if (outline.halfspace) return std::nullopt;
  const Interval range = along(direction, outline.points);
  return Interval{range.low - outline.radius, range.high + outline.radius};
}

// Where the hulls meet, the way out is shortest along an edge normal of one of them: the edges of their Minkowski
// difference are theirs. Growing both by their radii moves its boundary out by the sum, along the same normal.
double gap_between(const Outline& a, const Outline& b) {
  if (a.halfspace && b.halfspace) return infinity;
  if (a.halfspace) return gap_to(*a.halfspace, b);
  if (b.halfspace) return gap_to(*b.halfspace, a);
  const double along_normals = std::max(gap_along_normals(a.points, b.points), gap_along_normals(b.points, a.points));
  const bool meet = along_normals <= 0 && along_normals > -infinity;
  const double gap = meet ? along_normals : std::min(distance(a.points, b.points), distance(b.points, a.points));
  return gap - a.radius - b.radius;
}

}  // namespace plumb
