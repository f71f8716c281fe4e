#include "shapes/hull.h"

#include <algorithm>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

Edge Hull::edge(int i) const {
  const int next = i + 1 < count ? i + 1 : 0;
  const auto at = static_cast<std::size_t>(i);
  return {vertices[at], vertices[static_cast<std::size_t>(next)], normals[at], i, next, radius};
}

Hull hull_of(const Shape& shape) {
  Hull hull;
  hull.count = shape.count();
  hull.radius = shape.radius();
  hull.centroid = shape.centroid();
  for (int i = 0; i < hull.count; ++i) {
    hull.vertices[static_cast<std::size_t>(i)] = shape.vertex(i);
    hull.normals[static_cast<std::size_t>(i)] = shape.normal(i);
  }
  return hull;
}

Hull hull_of(const Shape& shape, const Pose& pose) {
  Hull hull;
  hull.count = shape.count();
  hull.radius = shape.radius();
  hull.centroid = to_world(pose, shape.centroid());
  for (int i = 0; i < hull.count; ++i) {
    hull.vertices[static_cast<std::size_t>(i)] = to_world(pose, shape.vertex(i));
    hull.normals[static_cast<std::size_t>(i)] = pose.q * shape.normal(i);
  }
  return hull;
}

Face face_against(const Hull& hull, int edge, const Hull& other) {
  const auto at = static_cast<std::size_t>(edge);
  const Vec2 n = hull.normals[at];
  int support = 0;
  Real lowest = std::numeric_limits<Real>::infinity();
  for (int j = 0; j < other.count; ++j) {
    const Real height = dot(n, other.vertices[static_cast<std::size_t>(j)]);
    if (height < lowest) {
      lowest = height;
      support = j;
    }
  }
  return {edge, support, lowest - dot(n, hull.vertices[at])};
}

Face best_face(const Hull& hull, const Hull& other) {
  Face best{0, 0, -std::numeric_limits<Real>::infinity()};
  for (int i = 0; i < hull.count; ++i) {
    const Face face = face_against(hull, i, other);
    if (face.separation > best.separation) best = face;
  }
  return best;
}

int edge_against(const Hull& hull, int vertex, Vec2 normal) {
  const int before = vertex > 0 ? vertex - 1 : hull.count - 1;
  const Real facing_before = dot(normal, hull.normals[static_cast<std::size_t>(before)]);
  const Real facing_after = dot(normal, hull.normals[static_cast<std::size_t>(vertex)]);
  return facing_before < facing_after ? before : vertex;
}

namespace {

// Whether b lies to the right of the line from a to c by more than the rounding of its coordinates.
bool is_corner(Vec2 a, Vec2 b, Vec2 c, Real rounding) {
  return cross(b - a, c - b) > rounding * (length(b - a) + length(c - b));
}

// Half of A. M. Andrew's monotone chain ("Another efficient algorithm for convex hulls in two dimensions", 1979):
// visits the points in order and keeps only left turns.
template <class Points>
std::vector<Vec2> half_hull(const Points& points, Real rounding) {
  std::vector<Vec2> hull;
  for (const Vec2 p : points) {
    while (hull.size() >= 2 && !is_corner(hull[hull.size() - 2], hull.back(), p, rounding)) hull.pop_back();
    hull.push_back(p);
  }
  return hull;
}

}  // namespace

std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;

  Real largest = 0;
  for (const Vec2 p : sorted) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon() * largest;

  std::vector<Vec2> hull = half_hull(sorted, rounding);
  std::reverse(sorted.begin(), sorted.end());
  const std::vector<Vec2> upper = half_hull(sorted, rounding);
  hull.insert(hull.end(), upper.begin() + 1, upper.end() - 1);
  return hull;
}

Real width(std::span<const Vec2> polygon) {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 along = normalized(polygon[(i + 1) % polygon.size()] - polygon[i]);
    Real across = 0;
    for (const Vec2 p : polygon) across = std::max(across, cross(along, p - polygon[i]));
    least = std::min(least, across);
  }
  return least;
}

Real diameter(std::span<const Vec2> points) {
  Real greatest = 0;
  for (const Vec2 a : points) {
    for (const Vec2 b : points) greatest = std::max(greatest, length(a - b));
  }
  return greatest;
}

}  // namespace impulse::inline IMPULSE_PRECISION
