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

// Newton's method on the distance, which is a convex function of the way: a step never passes the first contact (the
// conservative advancement of B. Mirtich, Impulse-based Dynamic Simulation, 1996, 2.3). Where shapes only graze each
// other, a step halves the rest of the way, so that 64 are enough for any precision.
std::optional<RayHit> shape_cast(const Shape& moving, const Pose& start, Vec2 by, const Shape& other,
                                 const Pose& pose) {
  if (other.in_chain() && dot(by, pose.q * other.normal(0)) >= 0) return std::nullopt;
  constexpr int most_steps = 64;
  // A gap that rounding cannot close: at contact, distance() knows no normal.
  const Real size = length(start.p) + length(by) + length(pose.p) + moving.extent();
  const Real gap_left = 16 * std::numeric_limits<Real>::epsilon() * size;
  RayHit hit{0, start.p, {}};
  for (int i = 0; i < most_steps; ++i) {
    const Gap gap = distance(moving, {start.p + hit.fraction * by, start.q}, other, pose);
    if (gap.distance == 0) return hit;
    hit.point = gap.b;
    hit.normal = -gap.normal;
    const Real closing = dot(by, gap.normal);  // m
    if (closing <= 0) return std::nullopt;
    if (gap.distance <= 2 * gap_left) return hit;
    hit.fraction += (gap.distance - gap_left) / closing;
    if (hit.fraction > 1) return std::nullopt;
  }
  return hit;
}

}  // namespace impulse::inline IMPULSE_PRECISION
