#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/collide.h"
#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The incident edge in coordinates of the reference edge: x along the reference from its start, y out of it. The
/// outlines run in opposite directions, so the end of the incident edge lies over the start of the reference.
struct Overlay {
  Real length;     // m, of the reference
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

  /// Height of the incident edge above the point x of the reference, for x between low.x and high.x.
  Real height(Real x) const {
    const Real run = high.x - low.x;
    return run > 0 ? low.y + (x - low.x) / run * (high.y - low.y) : std::min(low.y, high.y);
  }
};

/// Clips the incident edge to the reference edge; gives up to two points along the reference's normal.
inline Manifold clip(const Edge& reference, const Edge& incident, const Overlay& over, Real margin) {
  Manifold m;
  m.normal = reference.normal;
  if (!over.overlaps()) return m;
  const Vec2 t = perpendicular(reference.normal);
  const auto report = [&](Vec2 at, std::uint32_t id) {
    const Real separation = at.y - reference.radius - incident.radius;
    if (separation > margin) return;
    const Real middle = reference.radius + separation / 2;
    add(m, reference.from + at.x * t + middle * reference.normal, separation, id);
  };
  const Vec2 low = over.low.x < 0 ? Vec2{0, over.height(0)} : over.low;
  const Vec2 high = over.high.x > over.length ? Vec2{over.length, over.height(over.length)} : over.high;
  report(low, feature(reference.first, incident.second));
  report(high, feature(reference.second, incident.first));
  return m;
}

/// rad; faces at a smaller angle count as parallel. The error of the contact normal is then smaller than this.
constexpr Real parallel = Real{1} / 128;

/// A corner of each edge.
struct Corners {
  bool closest = false;  // whether these are the closest points of the two edges
  Vec2 a, b;             // of the reference and of the incident edge
  int vertex_a = 0, vertex_b = 0;
};

/// Finds the ends of two separate edges that are closest to each other, if no other points are closer. Nearly parallel
/// edges that overlap count as faces even if their corners are slightly closer: a resting box must not lose one of its
/// two points.
inline Corners facing_corners(const Edge& reference, const Edge& incident, const Overlay& over) {
  const bool low_is_nearer = over.low.y < over.high.y;
  const Real nearer = low_is_nearer ? over.low.x : over.high.x;
  if (nearer >= 0 && nearer <= over.length) return {};
  const Vec2 run = over.high - over.low;
  if (over.overlaps() && std::abs(run.y) <= parallel * run.x) return {};

  const bool at_start = over.overlaps() ? nearer < 0 : over.high.x < 0;
  const Vec2 corner{at_start ? 0 : over.length, 0};
  const Real along = dot(corner - over.low, run);
  if (along > 0 && along < length_squared(run)) return {};
  const bool low_end = along <= 0;
  const Real x = low_end ? over.low.x : over.high.x;
  if (x >= 0 && x <= over.length) return {};
  return {true, at_start ? reference.from : reference.to, low_end ? incident.to : incident.from,
          at_start ? reference.first : reference.second, low_end ? incident.second : incident.first};
}

/// The manifold of two corners: one point, with the normal from corner to corner.
inline Manifold touch(const Edge& reference, const Edge& incident, const Corners& corners, Real margin) {
  Manifold m;
  const Vec2 offset = corners.b - corners.a;
  const Real distance = length(offset);
  m.normal = offset / distance;
  const Real separation = distance - reference.radius - incident.radius;
  if (separation > margin) return m;
  const Real middle = reference.radius + separation / 2;
  add(m, corners.a + middle * m.normal, separation, feature(corners.vertex_a, corners.vertex_b));
  return m;
}

/// m; if corners of shapes of this size (m) are closer than this, rounding changes the direction between them by more
/// than 1/1024.
constexpr Real blurred(Real size) { return 1024 * std::numeric_limits<Real>::epsilon() * size; }

constexpr bool opposite(Vec2 normal_a, Vec2 normal_b) {
  return dot(normal_a, normal_b) < parallel * parallel / 2 - 1;  // 1 - cos
}

/// Whether the second shape's face replaces the first's as the reference. Of two faces that lie on each other the
/// reference must not alternate from step to step, so the first is preferred by 0.1 mm and by 1/64 of the depth. The
/// error is of second order, because the points' separations are those of the clipped edge. Otherwise only the better
/// face is where they meet: which shape is the first depends on where they are.
constexpr bool beats(Real second, Real first, bool opposite_faces) {
  constexpr Real least = static_cast<Real>(1e-4);  // m
  if (!opposite_faces) return second > first;
  return second > (first > 0 ? first : first - first / 64) + least;
}

/// Adds the incident edge's deeper end: for overlapping shapes whose preferred face just misses the other's edge.
inline void add_deepest(Manifold& m, const Edge& reference, const Edge& incident, const Overlay& over, Real margin) {
  const bool low = over.low.y < over.high.y;
  const Real separation = (low ? over.low.y : over.high.y) - reference.radius - incident.radius;
  if (separation > margin) return;
  const Vec2 middle = (low ? incident.to : incident.from) - (incident.radius + separation / 2) * reference.normal;
  add(m, middle, separation,
      low ? feature(reference.first, incident.second) : feature(reference.second, incident.first));
}

/// The manifold of two shapes with these nearest faces. `separation` (m) is that of the faces without radii, along the
/// reference's normal; `size` (m) is the magnitude of the coordinates; `of_other` (m) the separation by the face of the
/// other shape, which was not preferred although it may be the one that separates them.
inline Manifold meet(const Edge& reference, const Edge& incident, Real separation, Real size, Real margin,
                     Real of_other = -std::numeric_limits<Real>::infinity()) {
  const Overlay over(reference, incident);
  const Real least = blurred(size);
  // Two lines end to end have no separating face, yet their corners may be separate. Slightly bent, one has.
  if (separation > 0 || (std::max(separation, of_other) > -least && !over.overlaps())) {
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
