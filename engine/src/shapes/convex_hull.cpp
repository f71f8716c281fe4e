#include "shapes/convex_hull.h"

#include <algorithm>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

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
