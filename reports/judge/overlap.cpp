#include "reports/judge/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;  // of distances

Interval along(Vec direction, std::span<const Vec> points) {
  Interval range{infinity, -infinity};
  for (const Vec point : points) {
    const double d = dot(direction, point);
    range = {std::min(range.low, d), std::max(range.high, d)};
  }
  return range;
}

// The largest gap between the projections of two hulls on the normals of a's edges, in either order, or any that is
// positive. A segment is projected along itself too, which separates it from points beyond its ends.
double gap_along_normals(std::span<const Vec> a, std::span<const Vec> b) {
  double largest = -infinity;
  const auto project_on = [&](Vec axis) {
    const Interval of_a = along(axis, a);
    const Interval of_b = along(axis, b);
    largest = std::max({largest, of_b.low - of_a.high, of_a.low - of_b.high});
  };
  for (std::size_t i = 0; i < a.size() && largest <= 0; ++i) {
    const Vec edge = a[(i + 1) % a.size()] - a[i];
    const double size = length(edge);
    if (size == 0) continue;
    project_on({edge.y / size, -edge.x / size});
    if (a.size() == 2) project_on({edge.x / size, edge.y / size});
  }
  return largest;
}

// The shortest way from an edge to a point.
Vec way_to(Vec point, Vec from, Vec to) {
  const Vec edge = to - from;
  const double square = dot(edge, edge);
  const double share = square == 0 ? 0 : std::clamp(dot(point - from, edge) / square, 0.0, 1.0);
  return point - from - share * edge;
}

// The smallest distance from a corner of a to an edge of b: if two hulls do not meet, one of their nearest points is a
// corner. What is certainly farther than another, though both are rounded, is not measured.
double distance(std::span<const Vec> a, std::span<const Vec> b) {
  double nearest = infinity;
  double farther = infinity;  // m^2
  for (const Vec point : a) {
    for (std::size_t i = 0; i < b.size(); ++i) {
      const Vec way = way_to(point, b[i], b[(i + 1) % b.size()]);
      if (dot(way, way) > farther) continue;
      nearest = std::min(nearest, length(way));
      farther = nearest * nearest * (1 + rounding);
    }
  }
  return nearest;
}

// m, how far an outline reaches from its first point.
double reach_of(const Outline& outline) {
  if (outline.halfspace) return infinity;
  double farthest = 0;
  for (const Vec point : outline.points) farthest = std::max(farthest, length(point - outline.points[0]));
  return farthest + outline.radius;
}

double gap_to(const HalfSpace& ground, const OutlineView& outline) {
  return along(ground.normal, outline.points).low - outline.radius - ground.offset;
}

}  // namespace

std::optional<Interval> range_along(Vec direction, const Outline& outline) {
  if (outline.halfspace) return std::nullopt;
  const Interval range = along(direction, outline.points);
  return Interval{range.low - outline.radius, range.high + outline.radius};
}

// If the hulls overlap, the shortest way out is along an edge normal of one of them, because the edges of their
// Minkowski difference are theirs. Growing both by their radii moves its boundary out by the sum, along the same
// normal.
double gap_between(const OutlineView& a, const OutlineView& b) {
  if (a.halfspace && b.halfspace) return infinity;
  if (a.halfspace) return gap_to(*a.halfspace, b);
  if (b.halfspace) return gap_to(*b.halfspace, a);
  if (a.points.size() == 1 && b.points.size() == 1) return length(a.points[0] - b.points[0]) - a.radius - b.radius;
  double along_normals = gap_along_normals(a.points, b.points);
  if (along_normals <= 0) along_normals = std::max(along_normals, gap_along_normals(b.points, a.points));
  const bool meet = along_normals <= 0 && along_normals > -infinity;
  const double gap = meet ? along_normals : std::min(distance(a.points, b.points), distance(b.points, a.points));
  return gap - a.radius - b.radius;
}

double gap_between(const Outline& a, const Outline& b) {
  return gap_between(OutlineView{a.points, a.radius, a.halfspace}, OutlineView{b.points, b.radius, b.halfspace});
}

Overlap::Overlap(const Scene& scene) : scene_(scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec center = mass_of(scene.bodies[i]).center;
    const std::vector<Shape>& shapes = scene.bodies[i].shapes;
    first_part_.push_back(parts_.size());
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const Outline outline = outline_of(shapes[k].geometry, center);
      parts_.push_back({i, k, outline, points_, reach_of(outline)});
      points_ += outline.points.size();
    }
  }
  first_part_.push_back(parts_.size());
  for (const Joint& joint : scene.joints) {
    jointed_.push_back(std::visit([](const auto& of) { return std::minmax(of.a, of.b); }, joint));
  }
  std::sort(jointed_.begin(), jointed_.end());
}

void Overlap::place(std::size_t body, const BodyState& state, std::span<Vec> points) const {
  const Vec facing{std::cos(state.angle), std::sin(state.angle)};
  for (std::size_t i = first_part_[body]; i < first_part_[body + 1]; ++i) {
    std::size_t at = parts_[i].first_point;
    for (const Vec point : parts_[i].outline.points) points[at++] = state.position + rotated(point, facing);
  }
}

OutlineView Overlap::view(const Part& part, const BodyState& state, std::span<const Vec> points) const {
  const Outline& outline = part.outline;
  if (outline.halfspace) return {{}, 0, placed(outline, state.position, state.angle).halfspace};
  return {points.subspan(part.first_point, outline.points.size()), outline.radius, std::nullopt};
}

bool Overlap::may_touch(std::size_t a, std::size_t b) const {
  const Body& one = scene_.bodies[a];
  const Body& other = scene_.bodies[b];
  if (a == b || (one.type != BodyType::dynamic && other.type != BodyType::dynamic)) return false;
  if ((one.layers & other.layers) == 0) return false;
  const std::pair<std::size_t, std::size_t> pair = std::minmax(a, b);
  return !std::binary_search(jointed_.begin(), jointed_.end(), pair);
}

std::vector<BodyGap> Overlap::near(std::span<const BodyState> states, std::span<const double> reach) const {
  struct Bounds {
    Interval x, y;  // of a part, grown by its body's reach
    std::size_t part = 0;
  };
  std::vector<Vec> points(points_);
  for (std::size_t i = 0; i < states.size(); ++i) place(i, states[i], points);
  std::vector<OutlineView> outlines;
  std::vector<Bounds> bounds;
  outlines.reserve(parts_.size());
  bounds.reserve(parts_.size());
  for (const Part& part : parts_) {
    outlines.push_back(view(part, states[part.body], points));
    const OutlineView& outline = outlines.back();
    const double by = reach[part.body] + outline.radius;
    const auto grown = [&](Vec direction) {
      if (outline.halfspace) return Interval{-infinity, infinity};
      const Interval range = along(direction, outline.points);
      return Interval{range.low - by, range.high + by};
    };
    bounds.push_back({grown({1, 0}), grown({0, 1}), bounds.size()});
  }
  // A part can only be near those after it that start before it ends.
  std::sort(bounds.begin(), bounds.end(), [](const Bounds& one, const Bounds& other) {
    return one.x.low != other.x.low ? one.x.low < other.x.low : one.part < other.part;
  });
  std::vector<BodyGap> gaps;
  for (auto one = bounds.begin(); one != bounds.end(); ++one) {
    for (auto other = one + 1; other != bounds.end() && other->x.low <= one->x.high; ++other) {
      if (other->y.low > one->y.high || one->y.low > other->y.high) continue;
      const bool in_order = parts_[one->part].body < parts_[other->part].body;
      const Part& a = parts_[in_order ? one->part : other->part];
      const Part& b = parts_[in_order ? other->part : one->part];
      if (!may_touch(a.body, b.body)) continue;
      const double gap = gap_between(outlines[one->part], outlines[other->part]);
      const double within = reach[a.body] + reach[b.body];
      if (gap <= within) gaps.push_back({a.body, b.body, gap, a.shape, b.shape, within});
    }
  }
  return gaps;
}

std::vector<BodyOverlap> Overlap::all(std::span<const BodyState> states) const {
  std::vector<BodyOverlap> overlaps;
  for (const BodyGap& pair : near(states, std::vector<double>(states.size()))) {
    if (pair.gap < 0) overlaps.push_back({pair.a, pair.b, -pair.gap});
  }
  return overlaps;
}

Overlap::Gaps Overlap::gaps(std::span<const BodyState> states) const { return {*this, states}; }

Overlap::Gaps::Gaps(const Overlap& overlap, std::span<const BodyState> states)
    : overlap_(overlap), states_(states), points_(overlap.points_), placed_(states.size()) {}

double Overlap::Gaps::between(std::size_t a, std::size_t b) {
  const auto [at, is_new] = known_.try_emplace({a, b});
  if (is_new) at->second = measured(a, b);
  return at->second;
}

double Overlap::Gaps::measured(std::size_t a, std::size_t b) {
  for (const std::size_t body : {a, b}) {
    if (!placed_[body]) overlap_.place(body, states_[body], points_);
    placed_[body] = true;
  }
  const auto certainly_beyond = [&](double gap, const Part& one, const Part& other) {
    const double reach = one.reach + other.reach;
    if (!(reach < infinity)) return false;
    return length(points_[one.first_point] - points_[other.first_point]) - reach > gap + rounding * (reach + gap);
  };
  double nearest = infinity;
  for (std::size_t i = overlap_.first_part_[a]; i < overlap_.first_part_[a + 1]; ++i) {
    const OutlineView one = overlap_.view(overlap_.parts_[i], states_[a], points_);
    for (std::size_t j = overlap_.first_part_[b]; j < overlap_.first_part_[b + 1]; ++j) {
      if (certainly_beyond(nearest, overlap_.parts_[i], overlap_.parts_[j])) continue;
      nearest = std::min(nearest, gap_between(one, overlap_.view(overlap_.parts_[j], states_[b], points_)));
    }
  }
  return nearest;
}

BodyOverlap Overlap::deepest(std::span<const BodyState> states) const {
  const std::vector<BodyOverlap> overlaps = all(states);
  const auto deeper = [](const BodyOverlap& one, const BodyOverlap& other) { return one.depth < other.depth; };
  return overlaps.empty() ? BodyOverlap{} : *std::max_element(overlaps.begin(), overlaps.end(), deeper);
}

}  // namespace plumb
