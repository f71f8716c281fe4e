#include <cmath>
#include <limits>

#include "narrow_phase/colliders.h"
#include "narrow_phase/edges.h"
#include "narrow_phase/link.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The other side of it.
Edge reversed(const Edge& edge) { return {edge.to, edge.from, -edge.normal, edge.second, edge.first, edge.radius}; }

// Of a face with normal n through p against a hull's core.
Face against_line(Vec2 p, Vec2 n, const Hull& hull) {
  Face face{0, 0, std::numeric_limits<Real>::infinity()};
  for (int i = 0; i < hull.count; ++i) {
    const Real height = dot(n, hull.vertices[static_cast<std::size_t>(i)] - p);
    if (height < face.separation) face = {0, i, height};
  }
  return face;
}

Manifold on_face(const Link& link, const Face& face, const Hull& hull, Real margin) {
  const Edge incident = hull.edge(edge_against(hull, face.support, link.face.normal));
  const Overlay over(link.face, incident);
  if (face.separation > 0) {
    const Corners corners = facing_corners(link.face, incident, over);
    if (corners.closest) {
      const Manifold m = touch(link.face, incident, corners, margin);
      return link.joint(corners.vertex_a).owner(m.normal) == Owner::self ? m : Manifold{};
    }
  }
  return clip(link.face, incident, over, margin);
}

Manifold on_joint(const Link& link, const Face& face, const Hull& hull, Real margin) {
  const Edge reference = hull.edge(face.edge);
  const Edge incident = dot(reference.normal, link.face.normal) < 0 ? link.face : reversed(link.face);
  return flipped(meet(reference, incident, face.separation, link.size, margin));
}

bool holds(const Hull& hull, Vec2 p) {
  for (int i = 0; i < hull.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (dot(hull.normals[at], p - hull.vertices[at]) > 0) return false;
  }
  return true;
}

// Whether a neighbour behind an outward bend has less far to push than the link's own face.
bool neighbour_pushes(const LinkEnd& joint, const Hull& hull, Real own) {
  return joint.bends_outward && !joint.free_end &&
         beats(against_line(joint.place, joint.other, hull).separation, own, false);
}

// The shortest way out of those that the line of links has: along the link's normal, or along a face of the hull that a
// joint allows. What touches a joint's neighbour as well, for it holds the joint, may be left to that neighbour.
// `in_front`: whether the link's own face may push; if not, only a joint that the hull holds does.
Manifold shortest_way_out(const Link& link, const Face& of_link, const Hull& hull, bool in_front, Real margin) {
  const Hull line = link.hull();
  Face allowed{-1, 0, in_front ? of_link.separation : -Shape::unbounded};
  for (int i = 0; i < hull.count; ++i) {
    const Face face = face_against(hull, i, line);
    const LinkEnd& joint = link.joint(face.support);
    if (joint.owner(-hull.normals[static_cast<std::size_t>(i)]) == Owner::nobody) continue;
    const bool reachable = in_front || holds(hull, joint.place);
    const bool better =
        allowed.edge < 0 ? beats(face.separation, allowed.separation, false) : face.separation > allowed.separation;
    if (reachable && better) allowed = face;
  }
  for (const LinkEnd* joint : {&link.start, &link.end}) {
    if (holds(hull, joint->place) && neighbour_pushes(*joint, hull, allowed.separation)) return {};
  }
  if (allowed.edge < 0) return in_front ? on_face(link, of_link, hull, margin) : Manifold{};
  const LinkEnd& joint = link.joint(allowed.support);
  const Owner owner = joint.owner(-hull.normals[static_cast<std::size_t>(allowed.edge)]);
  if (owner == Owner::neighbour && holds(hull, joint.place)) return {};
  return on_joint(link, allowed, hull, margin);
}

// Where the cores don't overlap, the nearest points decide, unless no joint allows their direction.
Manifold meet_apart(const Link& link, const Face& of_link, const Hull& hull, const Face& of_hull, bool in_front,
                    Real margin) {
  const Vec2 facing = hull.normals[static_cast<std::size_t>(of_hull.edge)];
  if (beats(of_hull.separation, of_link.separation, opposite(link.face.normal, facing))) {
    const LinkEnd& joint = link.joint(of_hull.support);
    const Manifold m = on_joint(link, of_hull, hull, margin);
    const Owner owner = joint.owner(m.normal);
    if (owner == Owner::self || m.count == 0) return m;
    if (owner == Owner::neighbour || neighbour_pushes(joint, hull, of_link.separation)) return {};
  }
  return in_front ? on_face(link, of_link, hull, margin) : Manifold{};
}

}  // namespace

Manifold chain_circle(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Link link(a);
  const Vec2 center = to_world(relative(pose_a, pose_b), b.centroid());
  const Vec2 out = center - link.face.from;
  const Real height = dot(out, link.face.normal);
  if (height < 0) return {};
  const Real along = dot(out, link.end.away);
  Manifold m;
  m.normal = link.face.normal;
  Real distance = height;
  const bool before = along < 0;
  if (before || along > dot(link.face.to - link.face.from, link.end.away)) {
    const Vec2 apart = center - (before ? link.face.from : link.face.to);
    distance = length(apart);
    m.normal = apart / distance;
    if (link.joint(before ? 0 : 1).owner(m.normal) != Owner::self) return {};
  }
  const Real separation = distance - b.radius();
  if (separation <= margin) add(m, center - (b.radius() + separation / 2) * m.normal, separation, 0);
  return to_world(pose_a, m);
}

Manifold chain_hull(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Link link(a);
  const Hull hull = hull_of(b, relative(pose_a, pose_b));
  // One-sided: what has its centre behind the face is not pushed by it, but may lean on a joint until all is behind.
  const bool in_front = dot(link.face.normal, hull.centroid - link.face.from) >= 0;
  const Real reach = margin + hull.radius;
  const Face of_link = against_line(link.face.from, link.face.normal, hull);
  if (of_link.separation > reach) return {};
  const Real behind = against_line(link.face.from, -link.face.normal, hull).separation;
  if (behind > 0) return {};
  const Face of_hull = best_face(hull, link.hull());
  if (of_hull.separation > reach) return {};
  const bool apart = of_link.separation > 0 || of_hull.separation > 0;
  return to_world(pose_a, apart ? meet_apart(link, of_link, hull, of_hull, in_front, margin)
                                : shortest_way_out(link, of_link, hull, in_front, margin));
}

}  // namespace impulse::inline IMPULSE_PRECISION
