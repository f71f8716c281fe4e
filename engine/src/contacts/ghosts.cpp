#include "contacts/ghosts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/edges.h"
#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m; a step up to this height is no obstacle.
constexpr Real flush = static_cast<Real>(1e-4);

constexpr int no_corner = 0xff;

bool same_direction(Vec2 normal_a, Vec2 normal_b) { return opposite(normal_a, -normal_b); }

bool has_normal(const Shape& shape, Rotation q, Vec2 n) {
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  for (int i = 0; i < shape.count(); ++i) {
    const Vec2 face = q * shape.normal(i);
    if (std::abs(cross(face, n)) <= rounding && dot(face, n) > 0) return true;
  }
  return false;
}

/// Whether two corners touch, or a corner and a disc: then the normal belongs to neither shape.
bool on_corners(const GroundContact& m, const BodySet& bodies) {
  const Rotation found = (m.dynamic_first() ? m.contact.found_a : m.contact.found_b).q;
  return !has_normal(m.ground, bodies.pose[m.fixed].q, m.up) &&
         (m.part.count() < 2 || !has_normal(m.part, found, -m.up));
}

/// Where the ground is nearest to a point of the contact.
Vec2 surface(const GroundContact& m, std::size_t point, const BodySet& bodies) {
  const Vec2 middle = m.dynamic_first() ? m.contact.points[point].arm_b : m.contact.points[point].arm_a;
  return bodies.pose[m.fixed].p + middle - m.contact.found_separation[point] / 2 * m.up;
}

/// Whether the part is nearest to no point of the ground that stands out of the plane.
bool hidden(const GroundContact& m, const Plane& plane, const BodySet& bodies) {
  if (m.ground.type() == ShapeType::half_space) return false;
  if (same_direction(m.up, plane.normal) && !on_corners(m, bodies)) return false;
  const auto count = static_cast<std::size_t>(m.contact.count);
  const Real least = std::min(m.contact.found_separation[0], m.contact.found_separation[count - 1]);
  for (std::size_t i = 0; i < count; ++i) {
    if (m.contact.found_separation[i] > least + flush) continue;
    if (plane.height(surface(m, i, bodies)) > flush) return false;
  }
  return true;
}

/// m, how far the face that the contact lies on goes in front of a plane; at a corner, how far the contact is.
Real reach(const GroundContact& m, const Plane& plane, const BodySet& bodies) {
  if (m.ground.type() == ShapeType::half_space) return std::numeric_limits<Real>::infinity();
  Real most = -std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.contact.count); ++i) {
    most = std::max(most, plane.height(surface(m, i, bodies)));
  }
  const Hull hull = hull_of(m.ground, bodies.pose[m.fixed]);
  for (int i = 0; i < hull.count; ++i) {
    const Edge face = hull.edge(i);
    if (!same_direction(face.normal, m.up)) continue;
    most = std::max({most, plane.height(face.from), plane.height(face.to)});
  }
  return most;
}

/// Collides the part with the whole plane of a face, which has no corners: points are others than those at a corner of
/// the ground. `margin`: m.
Manifold against_face(const Edge& face, const Shape& part, const Pose& pose, Real margin) {
  // Relative to the part, so that no precision is lost far from the origin.
  const Shape plane = Shape::half_space(face.normal, dot(face.normal, face.from - pose.p));
  Manifold manifold = collide(plane, {}, part, {{}, pose.q}, margin);
  for (ManifoldPoint& p : manifold.points) {
    p.point += pose.p;
    p.feature |= feature(no_corner, 0);
  }
  return manifold;
}

/// The height above the plane at which the part would touch the face first.
Real touching_height(const Manifold& on_face, const Plane& plane) {
  const ManifoldPoint& p = on_face.points[0];
  const ManifoldPoint& q = on_face.points[static_cast<std::size_t>(on_face.count - 1)];
  const ManifoldPoint& first = q.separation < p.separation ? q : p;
  return plane.height(first.point + first.separation / 2 * on_face.normal);
}

}  // namespace

GroundContact::GroundContact(const Contact& of, const BodySet& bodies, bool dynamic_first)
    : contact(of),
      fixed(dynamic_first ? of.body_b : of.body_a),
      dynamic(dynamic_first ? of.body_a : of.body_b),
      ground(bodies.detail[fixed].parts[dynamic_first ? of.part_b : of.part_a].shape),
      part(bodies.detail[dynamic].parts[dynamic_first ? of.part_a : of.part_b].shape),
      up(dynamic_first ? -of.normal : of.normal) {}

bool joined(const BodySet& bodies, std::uint32_t a, std::uint32_t b) {
  const Velocity& of_a = bodies.velocity[a];
  const Velocity& of_b = bodies.velocity[b];
  if (a == b || (!bodies.moves(a) && !bodies.moves(b))) return true;
  if (of_a.w != of_b.w) return false;
  const Vec2 carried = cross(of_a.w, bodies.pose[b].p - bodies.pose[a].p);
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  return length(of_a.v + carried - of_b.v) <= rounding * (length(of_a.v) + length(carried));
}

bool form_corner(const GroundContact& one, const GroundContact& other, const BodySet& bodies) {
  constexpr Real steep = static_cast<Real>(0.5);      // cosine: at 60 degrees, what comes sliding is stopped by half
  constexpr Real in_front = static_cast<Real>(0.01);  // m; rounding puts the end of a tile in front of the one before
  if (dot(one.up, other.up) >= steep) return false;
  return reach(one, {other.up, surface(other, 0, bodies)}, bodies) > in_front &&
         reach(other, {one.up, surface(one, 0, bodies)}, bodies) > in_front;
}

std::optional<Manifold> on_face(const Placed& ground, Vec2 up, const Placed& part, Real margin) {
  if (ground.shape.count() < 2) return {};
  const Hull hull = hull_of(ground.shape, ground.pose);
  for (int i = 0; i < hull.count && hull.radius == 0; ++i) {
    const Edge face = hull.edge(i);
    if (same_direction(face.normal, up)) return against_face(face, part.shape, part.pose, margin);
  }
  return {};
}

std::optional<Plane> face_under(const GroundContact& at, const BodySet& bodies) {
  const Pose& pose = bodies.pose[at.fixed];
  if (at.ground.type() == ShapeType::half_space) {
    const Vec2 n = pose.q * at.ground.normal(0);
    if (!same_direction(n, at.up)) return {};
    return Plane{n, pose.p + at.ground.offset() * n};
  }
  if (at.ground.count() < 2) return {};
  const Hull hull = hull_of(at.ground, pose);
  for (int i = 0; i < hull.count; ++i) {
    const Edge face = hull.edge(i);
    if (same_direction(face.normal, at.up)) return Plane{face.normal, face.from + hull.radius * face.normal};
  }
  return {};
}

std::optional<Manifold> without_ghost(const GroundContact& at, const Plane& plane, const BodySet& bodies,
                                      const Margin& margin) {
  if (!hidden(at, plane, bodies)) return {};
  const Hull hull = hull_of(at.ground, bodies.pose[at.fixed]);
  const Vec2 center = to_world(bodies.pose[at.dynamic], at.part.centroid());
  for (int i = 0; i < hull.count; ++i) {
    const Edge face = hull.edge(i);
    const Real top = std::max(plane.height(face.from), plane.height(face.to)) + hull.radius;
    const bool rises = top > flush && dot(face.normal, center - face.from) > 0;
    if (!rises) continue;
    if (same_direction(face.normal, at.up)) return {};
    // Its half-space would keep the part out of free space beneath an overhang, beyond a round end or above its top.
    if (dot(face.normal, plane.normal) < 0 || hull.radius > 0) return {};
    Manifold on_face =
        against_face(face, at.part, bodies.pose[at.dynamic], speculative_gap(bodies, at.fixed, at.dynamic, margin));
    if (on_face.count > 0 && touching_height(on_face, plane) > top) return {};
    return at.dynamic_first() ? flipped(on_face) : on_face;
  }
  return Manifold{};
}

}  // namespace impulse::inline IMPULSE_PRECISION
