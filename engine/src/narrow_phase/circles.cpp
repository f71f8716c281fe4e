#include <cmath>

#include "narrow_phase/collide.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The feature of a circle's contact point, which stays the same while the circle rolls from edge to edge.
constexpr std::uint32_t rolling = 0;

// All in one frame; `outward` is the normal of the other shape towards the circle's centre.
Manifold round_contact(Vec2 center, Real radius, Vec2 outward, Real separation, Real margin) {
  Manifold m;
  m.normal = -outward;
  if (separation <= margin) add(m, center - (radius + separation / 2) * outward, separation, rolling);
  return m;
}

// The other shape is a point grown by `core_radius`; the normal is `fallback` if the centres coincide.
Manifold point_contact(Vec2 center, Real radius, Vec2 core, Real core_radius, Vec2 fallback, Real margin) {
  const Vec2 apart = center - core;
  const Real distance = length(apart);
  const Vec2 outward = distance > 0 ? apart / distance : fallback;
  return round_contact(center, radius, outward, distance - radius - core_radius, margin);
}

Vec2 center_seen_from(const Pose& frame, const Shape& circle, const Pose& pose) {
  return to_world(relative(frame, pose), circle.centroid());
}

}  // namespace

Manifold circle_circle(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Vec2 center = center_seen_from(pose_b, a, pose_a);
  return to_world(pose_b, point_contact(center, a.radius(), b.centroid(), b.radius(), {0, -1}, margin));
}

Manifold circle_box(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Pose frame{to_world(pose_b, b.centroid()), pose_b.q * Rotation(b.normal(1).x, b.normal(1).y)};
  const Vec2 between = (pose_a.p - pose_b.p) + (pose_a.q * a.centroid() - pose_b.q * b.centroid());
  const Vec2 center = frame.q.inverse() * between;
  const Vec2 h = b.half_extents();
  const Vec2 nearest{clamp(center.x, -h.x, h.x), clamp(center.y, -h.y, h.y)};
  if (!(nearest == center)) return to_world(frame, point_contact(center, a.radius(), nearest, 0, {}, margin));

  const Real out_x = std::abs(center.x) - h.x;
  const Real out_y = std::abs(center.y) - h.y;
  const Vec2 outward =
      out_x > out_y ? Vec2{center.x < 0 ? Real{-1} : Real{1}, 0} : Vec2{0, center.y < 0 ? Real{-1} : Real{1}};
  return to_world(frame, round_contact(center, a.radius(), outward, std::max(out_x, out_y) - a.radius(), margin));
}

Manifold circle_polygon(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Vec2 center = center_seen_from(pose_b, a, pose_a);
  int face = 0;
  Real separation = dot(b.normal(0), center - b.vertex(0));
  for (int i = 1; i < b.count(); ++i) {
    const Real s = dot(b.normal(i), center - b.vertex(i));
    if (s > separation) {
      separation = s;
      face = i;
    }
  }
  const Vec2 from = b.vertex(face);
  const Vec2 to = b.vertex(face + 1 < b.count() ? face + 1 : 0);
  const Vec2 n = b.normal(face);
  // Only from outside may a corner be nearest; it is an end of the best face.
  if (separation > 0 && dot(center - from, to - from) < 0) {
    return to_world(pose_b, point_contact(center, a.radius(), from, 0, n, margin));
  }
  if (separation > 0 && dot(center - to, to - from) > 0) {
    return to_world(pose_b, point_contact(center, a.radius(), to, 0, n, margin));
  }
  return to_world(pose_b, round_contact(center, a.radius(), n, separation - a.radius(), margin));
}

Manifold circle_capsule(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Vec2 center = center_seen_from(pose_b, a, pose_a);
  const Vec2 from = b.vertex(0);
  const Vec2 axis = b.vertex(1) - from;
  const Real along = dot(center - from, axis) / length_squared(axis);
  if (along <= 0) return to_world(pose_b, point_contact(center, a.radius(), from, b.radius(), b.normal(0), margin));
  if (along >= 1) {
    return to_world(pose_b, point_contact(center, a.radius(), b.vertex(1), b.radius(), b.normal(0), margin));
  }
  const Real height = dot(center - from, b.normal(0));
  const Vec2 outward = height < 0 ? -b.normal(0) : b.normal(0);
  const Real separation = std::abs(height) - a.radius() - b.radius();
  return to_world(pose_b, round_contact(center, a.radius(), outward, separation, margin));
}

// A segment is a capsule without thickness.
Manifold circle_segment(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  if (b.in_chain()) return flipped(chain_circle(b, pose_b, a, pose_a, margin));
  return circle_capsule(a, pose_a, b, pose_b, margin);
}

}  // namespace impulse::inline IMPULSE_PRECISION
