#include "narrow_phase/ghosts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/closing.h"
#include "narrow_phase/collide.h"
#include "narrow_phase/edges.h"
#include "narrow_phase/manifolds.h"
#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m; a step no higher than this is no obstacle.
constexpr Real flush = static_cast<Real>(1e-4);

bool alike(Vec2 normal_a, Vec2 normal_b) { return opposite(normal_a, -normal_b); }

bool has_normal(const Shape& shape, Rotation q, Vec2 n) {
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  for (int i = 0; i < shape.count(); ++i) {
    const Vec2 face = q * shape.normal(i);
    if (std::abs(cross(face, n)) <= rounding && dot(face, n) > 0) return true;
  }
  return false;
}

/// Whether two corners meet, or a corner and a disc: then the normal is neither's.
bool on_corners(const Meeting& m, const BodySet& bodies) {
  const Rotation found = (m.dynamic_first() ? m.contact.found_a : m.contact.found_b).q;
  return !has_normal(m.ground, bodies.pose[m.fixed].q, m.up) &&
         (m.part.count() < 2 || !has_normal(m.part, found, -m.up));
}

/// Whether the part meets nothing of the ground that stands out of the plane.
bool hidden(const Meeting& m, const Plane& plane, const BodySet& bodies) {
  if (m.ground.type() == ShapeType::half_space) return false;
  if (alike(m.up, plane.normal) && !on_corners(m, bodies)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.contact.count); ++i) {
    const Vec2 middle = m.dynamic_first() ? m.contact.points[i].arm_b : m.contact.points[i].arm_a;
    const Vec2 surface = bodies.pose[m.fixed].p + middle - m.contact.found_separation[i] / 2 * m.up;
    if (plane.height(surface) > flush) return false;
  }
  return true;
}

/// The part against the whole plane of a face.
Manifold against_face(const Meeting& m, const Edge& face, const BodySet& bodies, const Margin& margin) {
  // Seen from where the part is: far from the origin nothing is lost.
  const Pose& pose = bodies.pose[m.dynamic];
  const Shape plane = Shape::half_space(face.normal, dot(face.normal, face.from - pose.p));
  Manifold manifold = collide(plane, {}, m.part, {{}, pose.q}, closing(bodies, m.fixed, m.dynamic, margin));
  for (ManifoldPoint& p : manifold.points) p.point += pose.p;
  return manifold;
}

/// How high above the plane the part would touch the face first.
Real touching_height(const Manifold& on_face, const Plane& plane) {
  const ManifoldPoint& p = on_face.points[0];
  const ManifoldPoint& q = on_face.points[static_cast<std::size_t>(on_face.count - 1)];
  const ManifoldPoint& first = q.separation < p.separation ? q : p;
  return plane.height(first.point + first.separation / 2 * on_face.normal);
}

}  // namespace

Meeting::Meeting(const Contact& of, const BodySet& bodies, bool dynamic_first)
    : contact(of),
      fixed(dynamic_first ? of.body_b : of.body_a),
      dynamic(dynamic_first ? of.body_a : of.body_b),
      ground(bodies.detail[fixed].parts[dynamic_first ? of.part_b : of.part_a].shape),
      part(bodies.detail[dynamic].parts[dynamic_first ? of.part_a : of.part_b].shape),
      up(dynamic_first ? -of.normal : of.normal) {}

std::optional<Plane> face_under(const Meeting& meeting, const BodySet& bodies) {
  const Pose& pose = bodies.pose[meeting.fixed];
  if (meeting.ground.type() == ShapeType::half_space) {
    const Vec2 n = pose.q * meeting.ground.normal(0);
    if (!alike(n, meeting.up)) return {};
    return Plane{n, pose.p + meeting.ground.offset() * n};
  }
  if (meeting.ground.count() < 2) return {};
  const Hull hull = hull_of(meeting.ground, pose);
  for (int i = 0; i < hull.count; ++i) {
    const Edge face = hull.edge(i);
    if (alike(face.normal, meeting.up)) return Plane{face.normal, face.from + hull.radius * face.normal};
  }
  return {};
}

std::optional<Manifold> without_ghost(const Meeting& meeting, const Plane& plane, const BodySet& bodies,
                                      const Margin& margin) {
  if (!hidden(meeting, plane, bodies)) return {};
  const Hull hull = hull_of(meeting.ground, bodies.pose[meeting.fixed]);
  const Vec2 center = to_world(bodies.pose[meeting.dynamic], meeting.part.centroid());
  for (int i = 0; i < hull.count; ++i) {
    const Edge face = hull.edge(i);
    const Real top = std::max(plane.height(face.from), plane.height(face.to)) + hull.radius;
    const bool rises = top > flush && dot(face.normal, center - face.from) > 0;
    if (!rises) continue;
    if (alike(face.normal, meeting.up)) return {};
    // Its half-space would keep the part from what is free beneath an overhang, beyond a round end or above its top.
    if (dot(face.normal, plane.normal) < 0 || hull.radius > 0) return {};
    Manifold on_face = against_face(meeting, face, bodies, margin);
    if (on_face.count > 0 && touching_height(on_face, plane) > top) return {};
    return meeting.dynamic_first() ? flipped(on_face) : on_face;
  }
  return Manifold{};
}

}  // namespace impulse::inline IMPULSE_PRECISION
