#include "narrow_phase/collide.h"
#include "narrow_phase/edges.h"
#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The magnitude of a hull's coordinates, which limits their precision.
Real size_of(const Hull& hull) { return std::abs(hull.vertices[0].x) + std::abs(hull.vertices[0].y); }

// The reference face belongs to `hull`.
Manifold against(const Hull& hull, const Face& face, const Hull& other, const Face& of_other, Real margin) {
  const Edge reference = hull.edge(face.edge);
  const Edge incident = other.edge(edge_against(other, face.support, reference.normal));
  const Real size = size_of(hull) + size_of(other);
  return meet(reference, incident, face.separation, size, margin, of_other.separation);
}

// Adds a point of a shape with rounding radius `radius` over the plane.
void add_above(Manifold& m, const Shape& plane, Vec2 point, Real radius, Real margin, int vertex) {
  const Real separation = dot(plane.normal(0), point) - plane.offset() - radius;
  if (separation > margin) return;
  add(m, point - (radius + separation / 2) * plane.normal(0), separation, feature(vertex, 0));
}

}  // namespace

// Separating axes in the frame of the first, then clipping.
Manifold hull_hull(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Hull first = hull_of(a);
  const Hull second = hull_of(b, relative(pose_a, pose_b));
  const Real reach = margin + first.radius + second.radius;
  const Face of_first = best_face(first, second);
  if (of_first.separation > reach) return {};
  const Face of_second = best_face(second, first);
  if (of_second.separation > reach) return {};
  const Vec2 normal_a = first.normals[static_cast<std::size_t>(of_first.edge)];
  const Vec2 normal_b = second.normals[static_cast<std::size_t>(of_second.edge)];
  if (beats(of_second.separation, of_first.separation, opposite(normal_a, normal_b))) {
    return to_world(pose_a, flipped(against(second, of_second, first, of_first, margin)));
  }
  return to_world(pose_a, against(first, of_first, second, of_second, margin));
}

Manifold hull_segment(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  if (b.in_chain()) return flipped(chain_hull(b, pose_b, a, pose_a, margin));
  // Shapes slide on the segment, so its face is preferred as the reference face.
  return flipped(hull_hull(b, pose_b, a, pose_a, margin));
}

Manifold circle_half_space(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  Manifold m;
  m.normal = -b.normal(0);
  add_above(m, b, to_world(relative(pose_b, pose_a), a.centroid()), a.radius(), margin, 0);
  return to_world(pose_b, m);
}

// Both ends of the edge at the deepest vertex that faces the plane more: its other end is where the shape lands next.
// The deeper of the two neighbours would not do: it may be the other side of a slender foot, and the far end of a shape
// that falls over would come down without a contact.
Manifold hull_half_space(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Pose there = relative(pose_b, pose_a);
  const Vec2 up = there.q.inverse() * b.normal(0);  // heights are compared in the hull's frame
  int deepest = 0;
  for (int i = 1; i < a.count(); ++i) {
    if (dot(up, a.vertex(i)) < dot(up, a.vertex(deepest))) deepest = i;
  }
  const int before = deepest > 0 ? deepest - 1 : a.count() - 1;
  const int after = deepest + 1 < a.count() ? deepest + 1 : 0;
  const bool faces_before = dot(up, a.normal(before)) < dot(up, a.normal(deepest));

  Manifold m;
  m.normal = -b.normal(0);
  const int first = faces_before ? before : deepest;
  const int second = faces_before ? deepest : after;
  add_above(m, b, to_world(there, a.vertex(first)), a.radius(), margin, first);
  add_above(m, b, to_world(there, a.vertex(second)), a.radius(), margin, second);
  return to_world(pose_b, m);
}

}  // namespace impulse::inline IMPULSE_PRECISION
