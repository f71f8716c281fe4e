#include "narrow_phase/colliders.h"
#include "narrow_phase/manifolds.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// A point of a shape grown by `radius`, above the plane.
void add_above(Manifold& m, const Shape& plane, Vec2 point, Real radius, Real margin, int vertex) {
  const Real separation = dot(plane.normal(0), point) - plane.offset() - radius;
  if (separation > margin) return;
  add(m, point - (radius + separation / 2) * plane.normal(0), separation, feature(vertex, 0));
}

}  // namespace

Manifold circle_half_space(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  Manifold m;
  m.normal = -b.normal(0);
  add_above(m, b, to_world(relative(pose_b, pose_a), a.centroid()), a.radius(), margin, 0);
  return to_world(pose_b, m);
}

// The edge at the deepest vertex that faces the plane: its other end is where the shape lands next. The deeper of the
// two neighbours may be the other side of a slender foot, while the far end of what falls over comes down unseen.
Manifold hull_half_space(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Pose there = relative(pose_b, pose_a);
  const Vec2 down = there.q.inverse() * b.normal(0);  // heights are compared in the hull's frame
  int deepest = 0;
  for (int i = 1; i < a.count(); ++i) {
    if (dot(down, a.vertex(i)) < dot(down, a.vertex(deepest))) deepest = i;
  }
  const int before = deepest > 0 ? deepest - 1 : a.count() - 1;
  const int after = deepest + 1 < a.count() ? deepest + 1 : 0;
  const bool faces_before = dot(down, a.normal(before)) < dot(down, a.normal(deepest));

  Manifold m;
  m.normal = -b.normal(0);
  const int first = faces_before ? before : deepest;
  const int second = faces_before ? deepest : after;
  add_above(m, b, to_world(there, a.vertex(first)), a.radius(), margin, first);
  add_above(m, b, to_world(there, a.vertex(second)), a.radius(), margin, second);
  return to_world(pose_b, m);
}

}  // namespace impulse::inline IMPULSE_PRECISION
