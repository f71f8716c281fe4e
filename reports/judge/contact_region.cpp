#include "reports/judge/contact_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// Leaves what lies on the inner side of a line: normal . p <= offset.
void cut(std::vector<Vec>& hull, Vec normal, double offset) {
  const auto is_outside = [&](Vec point) { return dot(normal, point) > offset; };
  if (std::none_of(hull.begin(), hull.end(), is_outside)) return;
  std::vector<Vec> inside;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec from = hull[i];
    const Vec to = hull[(i + 1) % hull.size()];
    const double out_from = dot(normal, from) - offset;
    const double out_to = dot(normal, to) - offset;
    if (out_from <= 0) inside.push_back(from);
    if (out_from * out_to < 0) inside.push_back(from + out_from / (out_from - out_to) * (to - from));
  }
  hull = std::move(inside);
}

// Cuts by the tangent of a core in a direction, moved out by a reach.
void cut_by_tangent(std::vector<Vec>& hull, std::span<const Vec> core, Vec normal, double reach) {
  double offset = -std::numeric_limits<double>::infinity();
  for (const Vec point : core) offset = std::max(offset, dot(normal, point));
  cut(hull, normal, offset + reach);
}

// Directions around a corner: those of the sides of a regular polygon of 16.
const std::array<Vec, 16>& around() {
  static const std::array<Vec, 16> directions = [] {
    std::array<Vec, 16> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = rotated({1, 0}, 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(all.size()));
    }
    return all;
  }();
  return directions;
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
  std::vector<Vec> region = of.points;
  if (other.halfspace) {
    cut(region, other.halfspace->normal, other.halfspace->offset + reach);
    return region;
  }
  const std::vector<Vec>& core = other.points;
  for (const Vec normal : around()) cut_by_tangent(region, core, normal, reach);
  for (std::size_t i = 0; i < core.size() && core.size() > 1; ++i) {
    const Vec edge = core[(i + 1) % core.size()] - core[i];
    const double size = length(edge);
    if (size == 0) continue;
    const Vec normal{edge.y / size, -edge.x / size};
    cut_by_tangent(region, core, normal, reach);
    cut_by_tangent(region, core, -1 * normal, reach);
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
