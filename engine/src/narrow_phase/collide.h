#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "impulse/math.h"
#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

struct ManifoldPoint {
  Vec2 point;                 // midway between the two surfaces; frame as the manifold's
  Real separation = 0;        // m, along the normal; negative when they overlap
  std::uint32_t feature = 0;  // see feature(); the same from step to step while the contact is the same
};

/// How two shapes touch: up to two points along one normal.
struct Manifold {
  Vec2 normal;  // unit, from a to b
  int count = 0;
  std::array<ManifoldPoint, 2> points;
};

/// Identifies a contact point by the adjacent corner of each shape. Two faces that lie on each other have a point at
/// each end of their overlap; whichever of the two corners limits the overlap there, and whichever shape has the
/// reference face, the id is the same, so it lasts while the same faces meet.
constexpr std::uint32_t feature(int corner_of_a, int corner_of_b) {
  return static_cast<std::uint32_t>(corner_of_a) | static_cast<std::uint32_t>(corner_of_b) << 8;
}

/// The same contact with the shapes' roles swapped.
inline Manifold flipped(Manifold m) {
  m.normal = -m.normal;
  for (ManifoldPoint& p : m.points) p.feature = (p.feature & 0xff) << 8 | p.feature >> 8;
  return m;
}

inline Manifold to_world(const Pose& frame, Manifold m) {
  m.normal = frame.q * m.normal;
  for (ManifoldPoint& p : m.points) p.point = to_world(frame, p.point);
  return m;
}

inline void add(Manifold& m, Vec2 point, Real separation, std::uint32_t feature) {
  m.points[static_cast<std::size_t>(m.count++)] = {point, separation, feature};
}

/// Finds the manifold of any two shapes (the article's jump table), in the world frame. Points whose separation exceeds
/// `margin` (m, >= 0) are left out. Swapping a and b flips the manifold exactly.
Manifold collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin);

/// Makes the manifold of two shapes of fixed types, the first of which comes no later in ShapeType; for two of one
/// type, collide() chooses the first.
using Collider = Manifold(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin);

Collider circle_circle;
Collider circle_box;
Collider circle_polygon;
Collider circle_capsule;
Collider circle_segment;
Collider circle_half_space;
Collider box_box;
Collider hull_hull;  // box, polygon, capsule, segment
Collider hull_segment;
Collider hull_half_space;

/// The part of circle_segment and hull_segment for segments of a chain; the segment comes first.
Collider chain_circle;
Collider chain_hull;

}  // namespace impulse::inline IMPULSE_PRECISION
