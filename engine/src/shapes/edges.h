#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/manifolds.h"

namespace impulse::inline IMPULSE_PRECISION {

/// An edge of a convex outline that runs counter-clockwise.
struct Edge {
  Vec2 from, to;
  Vec2 normal;        // unit, out of the shape
  int first, second;  // number of the vertex at `from`, at `to`
  Real radius;        // the surface lies this far out from the edge
};

/// An edge as it lies over another, the reference: x along the reference from its start, y out of it. The outlines run
/// in opposite directions, so the incident edge's end lies over the reference's start.
struct Overlay {
  Real length;     // of the reference
  Vec2 low, high;  // the incident edge's `to`, `from`

  Overlay(const Edge& reference, const Edge& incident) {
    const Vec2 n = reference.normal;
    const Vec2 t = perpendicular(n);
    const Vec2 to = incident.to - reference.from;
    const Vec2 from = incident.from - reference.from;
    length = dot(reference.to - reference.from, t);
    low = {dot(to, t), dot(to, n)};
    high = {dot(from, t), dot(from, n)};
  }

  bool overlaps() const { return low.x <= length && high.x >= 0; }

  /// Height of the incident edge above the place x of the reference; x between low.x and high.x.
  Real height(Real x) const {
    const Real run = high.x - low.x;
    return run > 0 ? low.y + (x - low.x) / run * (high.y - low.y) : std::min(low.y, high.y);
  }
};

/// The part of the incident edge over the reference edge, as up to two points along the reference's normal.
inline Manifold clip(const Edge& reference, const Edge& incident, const Overlay& over, Real margin) {
  Manifold m;
  m.normal = reference.normal;
  if (!over.overlaps()) return m;
  const Vec2 t = perpendicular(reference.normal);
  const auto report = [&](Vec2 place, std::uint32_t name) {
    const Real separation = place.y - reference.radius - incident.radius;
    if (separation > margin) return;
    const Real middle = reference.radius + separation / 2;
    add(m, reference.from + place.x * t + middle * reference.normal, separation, name);
  };
  const Vec2 low = over.low.x < 0 ? Vec2{0, over.height(0)} : over.low;
  const Vec2 high = over.high.x > over.length ? Vec2{over.length, over.height(over.length)} : over.high;
  report(low, feature(reference.first, incident.second));
  report(high, feature(reference.second, incident.first));
  return m;
}

/// rad; faces that lean less count as lying on each other. What is taken for their normal errs by less.
constexpr Real parallel = Real{1} / 128;

/// Two corners that face each other.
struct Corners {
  bool closest = false;  // whether no other points of the two edges are as close
  Vec2 a, b;             // of the reference, of the incident edge
  int vertex_a = 0, vertex_b = 0;
};

/// Whether the ends of two separate edges are nearest to each other. Edges that are as good as parallel and lie over
/// each other count as faces even where corners are a little nearer: a resting box must not lose one of its two points.
inline Corners facing_corners(const Edge& reference, const Edge& incident, const Overlay& over) {
  const bool low_is_nearer = over.low.y < over.high.y;
  const Real nearer = low_is_nearer ? over.low.x : over.high.x;
  if (nearer >= 0 && nearer <= over.length) return {};
  const Vec2 run = over.high - over.low;
  if (over.overlaps() && std::abs(run.y) <= parallel * run.x) return {};

  const bool at_start = over.overlaps() ? nearer < 0 : over.high.x < 0;
  const Vec2 corner{at_start ? 0 : over.length, 0};
  const Real place = dot(corner - over.low, run);
  if (place > 0 && place < length_squared(run)) return {};
  const bool low_end = place <= 0;
  const Real x = low_end ? over.low.x : over.high.x;
  if (x >= 0 && x <= over.length) return {};
  return {true, at_start ? reference.from : reference.to, low_end ? incident.to : incident.from,
          at_start ? reference.first : reference.second, low_end ? incident.second : incident.first};
}

inline Manifold touch(const Edge& reference, const Edge& incident, const Corners& corners, Real margin) {
  Manifold m;
  const Vec2 apart = corners.b - corners.a;
  const Real distance = length(apart);
  m.normal = apart / distance;
  const Real separation = distance - reference.radius - incident.radius;
  if (separation > margin) return m;
  const Real middle = reference.radius + separation / 2;
  add(m, corners.a + middle * m.normal, separation, feature(corners.vertex_a, corners.vertex_b));
  return m;
}

/// Below this distance (m) between corners of shapes of this size (m), rounding blurs the direction by more than
/// 1/1024.
constexpr Real blurred(Real size) { return 1024 * std::numeric_limits<Real>::epsilon() * size; }

constexpr bool opposite(Vec2 normal_a, Vec2 normal_b) {
  return dot(normal_a, normal_b) < parallel * parallel / 2 - 1;  // 1 - cos
}

/// Whether the second shape's face replaces the first's as the reference. Faces that lie on each other, and overlapping
/// shapes, must not take turns while they tremble, so the first is preferred by 0.1 mm and a 64th of the depth; what is
/// given away is of second order, for the points' separations are those of the clipped edge. Of shapes apart only the
/// better face tells their distance.
constexpr bool beats(Real second, Real first, bool opposite_faces) {
  constexpr Real least = static_cast<Real>(1e-4);  // m
  if (first > 0) return second > (opposite_faces ? first + least : first);
  return second > first + least - first / 64;
}

/// The incident edge's deeper end: where shapes overlap although a preferred face just misses the other's edge.
inline void add_deepest(Manifold& m, const Edge& reference, const Edge& incident, const Overlay& over, Real margin) {
  const bool low = over.low.y < over.high.y;
  const Real separation = (low ? over.low.y : over.high.y) - reference.radius - incident.radius;
  if (separation > margin) return;
  const Vec2 middle = (low ? incident.to : incident.from) - (incident.radius + separation / 2) * reference.normal;
  add(m, middle, separation,
      low ? feature(reference.first, incident.second) : feature(reference.second, incident.first));
}

/// What two shapes make whose nearest faces these edges are; `separation` is of the faces without radii, along the
/// reference's normal, `size` that of the coordinates.
inline Manifold meet(const Edge& reference, const Edge& incident, Real separation, Real size, Real margin) {
  const Overlay over(reference, incident);
  const Real least = blurred(size);
  // Two lines end to end have no separating face; their corners are apart all the same.
  if (separation > 0 || (separation > -least && !over.overlaps())) {
    const Corners corners = facing_corners(reference, incident, over);
    if (corners.closest && length_squared(corners.b - corners.a) > least * least) {
      return touch(reference, incident, corners, margin);
    }
  }
  Manifold m = clip(reference, incident, over, margin);
  if (m.count == 0 && separation <= 0) add_deepest(m, reference, incident, over, margin);
  return m;
}

}  // namespace impulse::inline IMPULSE_PRECISION
