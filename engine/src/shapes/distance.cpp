#include "shapes/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The nearest points of two cores, and their distance squared.
struct NearestPoints {
  Vec2 a, b;
  Real squared = std::numeric_limits<Real>::infinity();
};

Vec2 nearest_on(Vec2 from, Vec2 to, Vec2 p) {
  const Vec2 run = to - from;
  const Real squared = length_squared(run);
  if (squared == 0) return from;
  return from + clamp(dot(p - from, run) / squared, 0, 1) * run;
}

// Two disjoint convex outlines are nearest at a vertex of one of them: here, of `one`.
NearestPoints vertices_to_edges(const Hull& one, const Hull& other) {
  NearestPoints best;
  for (int i = 0; i < one.count; ++i) {
    const Vec2 vertex = one.vertices[static_cast<std::size_t>(i)];
    for (int j = 0; j < other.count; ++j) {
      const Edge edge = other.edge(j);
      const Vec2 p = nearest_on(edge.from, edge.to, vertex);
      const Real squared = length_squared(p - vertex);
      if (squared < best.squared) best = {vertex, p, squared};
    }
  }
  return best;
}

// Whether no face of either hull separates the cores. Two parallel lines count as separate: their faces cannot tell.
bool cores_overlap(const Hull& a, const Hull& b) {
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  if (a.count < 3 && b.count < 3) {
    if (a.count < 2 || b.count < 2) return false;
    if (std::abs(cross(a.normals[0], b.normals[0])) <= rounding) return false;
  }
  const bool a_separates = a.count > 1 && best_face(a, b).separation > 0;
  const bool b_separates = b.count > 1 && best_face(b, a).separation > 0;
  return !a_separates && !b_separates;
}

// In the frame of the first hull.
Gap between_hulls(const Hull& a, const Hull& b) {
  if (cores_overlap(a, b)) return {};
  NearestPoints nearest = vertices_to_edges(a, b);
  const NearestPoints reverse = vertices_to_edges(b, a);
  if (reverse.squared < nearest.squared) nearest = {reverse.b, reverse.a, reverse.squared};
  const Real apart = std::sqrt(nearest.squared);
  if (apart <= a.radius + b.radius) return {};
  const Vec2 normal = (nearest.b - nearest.a) / apart;
  return {apart - a.radius - b.radius, nearest.a + a.radius * normal, nearest.b - b.radius * normal, normal};
}

// In the frame of the half-space, which comes first.
Gap above_half_space(const Shape& half_space, const Hull& hull) {
  const Vec2 n = half_space.normal(0);
  const auto lower = [n](Vec2 p, Vec2 q) { return dot(n, p) < dot(n, q); };
  const Vec2 lowest = *std::min_element(hull.vertices.begin(), hull.vertices.begin() + hull.count, lower);
  const Real height = dot(n, lowest) - half_space.offset() - hull.radius;
  if (height <= 0) return {};
  const Vec2 surface = lowest - hull.radius * n;
  return {height, surface - height * n, surface, n};
}

Gap to_world(const Pose& pose, const Gap& gap) {
  if (gap.distance == 0) return gap;
  return {gap.distance, to_world(pose, gap.a), to_world(pose, gap.b), pose.q * gap.normal};
}

}  // namespace

Gap distance(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  if (b.type() == ShapeType::half_space) {
    if (a.type() == ShapeType::half_space) return {};
    const Gap gap = distance(b, pose_b, a, pose_a);
    return {gap.distance, gap.b, gap.a, -gap.normal};
  }
  const Hull hull = hull_of(b, relative(pose_a, pose_b));
  if (a.type() == ShapeType::half_space) return to_world(pose_a, above_half_space(a, hull));
  return to_world(pose_a, between_hulls(hull_of(a), hull));
}

}  // namespace impulse::inline IMPULSE_PRECISION
