#include "narrow_phase/colliders.h"
#include "narrow_phase/edges.h"
#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// Of which hull the coordinates must be precise where they meet.
Real size_of(const Hull& hull) { return std::abs(hull.vertices[0].x) + std::abs(hull.vertices[0].y); }

// The reference face belongs to `hull`.
Manifold against(const Hull& hull, const Face& face, const Hull& other, Real margin) {
  const Edge reference = hull.edge(face.edge);
  const Edge incident = other.edge(edge_against(other, face.support, reference.normal));
  const Real size = size_of(hull) + size_of(other);
  return meet(reference, incident, face.separation, size, margin);
}

}  // namespace

// Separating axes in the first one's frame, then clipping.
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
    return to_world(pose_a, flipped(against(second, of_second, first, margin)));
  }
  return to_world(pose_a, against(first, of_first, second, margin));
}

Manifold hull_segment(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  if (b.in_chain()) return flipped(chain_hull(b, pose_b, a, pose_a, margin));
  // The line is what things slide on: its face is the first to be the reference.
  return flipped(hull_hull(b, pose_b, a, pose_a, margin));
}

}  // namespace impulse::inline IMPULSE_PRECISION
