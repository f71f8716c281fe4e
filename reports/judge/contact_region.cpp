#include "reports/judge/contact_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reports/vec.h"

namespace plumb {
namespace {

// What lies on the inner side of a line: normal . p <= offset.
std::vector<Vec> cut(const std::vector<Vec>& hull, Vec normal, double offset) {
  std::vector<Vec> inside;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec from = hull[i];
    const Vec to = hull[(i + 1) % hull.size()];
    const double out_from = dot(normal, from) - offset;
    const double out_to = dot(normal, to) - offset;
    if (out_from <= 0) inside.push_back(from);
    if (out_from * out_to < 0) inside.push_back(from + out_from / (out_from - out_to) * (to - from));
  }
  return inside;
}

// Normals of the tangents by which a core is enclosed: those of its edges, and of a 16-gon around its corners.
std::vector<Vec> tangents_of(const Outline& outline) {
  std::vector<Vec> normals;
  constexpr int corners = 16;
  for (int i = 0; i < corners; ++i) normals.push_back(rotated({1, 0}, 2 * std::numbers::pi * i / corners));
  const std::vector<Vec>& points = outline.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec edge = points[(i + 1) % points.size()] - points[i];
    const double size = length(edge);
    if (size == 0) continue;
    for (const double side : {-1.0, 1.0}) normals.push_back({side * edge.y / size, -side * edge.x / size});
  }
  return normals;
}

Vec nearest_on(Vec point, Vec from, Vec to) {
  const Vec edge = to - from;
  const double square = dot(edge, edge);
  return from + (square == 0 ? 0 : std::clamp(dot(point - from, edge) / square, 0.0, 1.0)) * edge;
}

// The shortest vector from a corner of one to an edge of the other.
Vec shortest(const std::vector<Vec>& corners, const std::vector<Vec>& edges) {
  Vec best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec point : corners) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Vec way = nearest_on(point, edges[i], edges[(i + 1) % edges.size()]) - point;
      if (length(way) >= nearest) continue;
      nearest = length(way);
      best = way;
    }
  }
  return best;
}

Outline core_of(Outline outline) {
  outline.radius = 0;
  return outline;
}

}  // namespace

std::vector<Vec> region_near(const Outline& of, const Outline& other, double reach) {
  if (other.halfspace) return cut(of.points, other.halfspace->normal, other.halfspace->offset + reach);
  std::vector<Vec> region = of.points;
  for (const Vec normal : tangents_of(other)) {
    region = cut(region, normal, range_along(normal, core_of(other))->high + reach);
  }
  return region;
}

std::optional<Vec> direction_to(const Outline& from, const Outline& to) {
  if (gap_between(core_of(from), core_of(to)) <= 0) return std::nullopt;
  if (to.halfspace) return -1 * to.halfspace->normal;
  const Vec way = shortest(from.points, to.points);
  const Vec back = shortest(to.points, from.points);
  const Vec shorter = length(way) <= length(back) ? way : -1 * back;
  return 1 / length(shorter) * shorter;
}

bool is_flat_in(const Outline& outline, const std::vector<Vec>& region) {
  if (outline.halfspace) return true;
  // A cut leaves corners as they are or takes them away.
  return std::none_of(outline.points.begin(), outline.points.end(),
                      [&](Vec corner) { return std::find(region.begin(), region.end(), corner) != region.end(); });
}

}  // namespace plumb
