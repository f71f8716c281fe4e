#include <cmath>
#include <limits>

#include "narrow_phase/collide.h"
#include "narrow_phase/edges.h"
#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Tilts below this are rounding.
constexpr Real joint_rounding = 64 * std::numeric_limits<Real>::epsilon();

/// Which segment of the chain a contact normal at a joint belongs to.
enum class Owner { self, neighbour, nobody };

/// One end of a link, where it meets its neighbour. On an outward bend, each link owns the half of the normals between
/// the two faces' that is nearer to its own; on a straight or inward joint only the normals of the two faces exist, and
/// a contact with another normal is a ghost.
struct LinkEnd {
  Vec2 place;
  Vec2 own, other;  // the two faces' normals
  Vec2 away;        // along this link, out over the joint
  bool bends_outward;
  bool free_end;  // bends outward as if the chain turned back

  Owner owner(Vec2 normal) const {
    const Real lean = dot(normal, away);
    if (lean < -joint_rounding) return Owner::nobody;
    if (lean <= joint_rounding && dot(normal, own) > 0) return Owner::self;
    if (!bends_outward) return Owner::nobody;
    const Real to_own = dot(normal, own);
    const Real to_other = dot(normal, other);
    const Real opening = dot(own, other) - joint_rounding;
    if (to_own < opening || to_other < opening) return Owner::nobody;  // beyond one of the two
    return to_own >= to_other ? Owner::self : Owner::neighbour;
  }
};

LinkEnd make_link_end(Vec2 place, Vec2 own, Vec2 away, Vec2 beyond) {
  const Vec2 onward = normalized(beyond - place);
  const Real turn = dot(own, onward);  // negative: the neighbour falls away from the free side
  const bool back = std::abs(turn) <= joint_rounding && dot(away, onward) < 0;
  // The neighbour's normal stands to `onward` as `own` does to `away`.
  const Vec2 other = cross(away, own) > 0 ? perpendicular(onward) : -perpendicular(onward);
  return {place, own, other, away, turn < -joint_rounding || back, back};
}

/// A segment of a chain in its own frame.
struct Link {
  Edge face;
  LinkEnd start, end;
  Real size;  // of its coordinates

  explicit Link(const Shape& segment) {
    const Vec2 n = segment.normal(0);
    const Vec2 t = perpendicular(n);
    const Vec2 from = segment.vertex(0);
    const Vec2 to = segment.vertex(1);
    size = std::abs(from.x) + std::abs(from.y) + std::abs(to.x) + std::abs(to.y);
    // Links extend over their joints by a few roundings, so that nothing falls between two.
    const Real reach = 4 * std::numeric_limits<Real>::epsilon() * size;
    face = {from - reach * t, to + reach * t, n, 0, 1, 0};
    start = make_link_end(face.from, n, -t, segment.ghost_before());
    end = make_link_end(face.to, n, t, segment.ghost_after());
  }
  const LinkEnd& joint(int vertex) const { return vertex == 0 ? start : end; }
  Hull hull() const {
    Hull line;
    line.count = 2;
    line.vertices = {face.from, face.to};
    line.normals = {face.normal, -face.normal};
    return line;
  }
};

// The back side of an edge.
Edge reversed(const Edge& edge) { return {edge.to, edge.from, -edge.normal, edge.second, edge.first, edge.radius}; }

// The separation of a hull's core from the line through p with normal n.
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

bool contains(const Hull& hull, Vec2 p) {
  for (int i = 0; i < hull.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (dot(hull.normals[at], p - hull.vertices[at]) > 0) return false;
  }
  return true;
}

// Whether the neighbour behind an outward bend separates the hull with a shorter push than the link's own face.
bool neighbour_pushes(const LinkEnd& joint, const Hull& hull, Real own) {
  return joint.bends_outward && !joint.free_end &&
         beats(against_line(joint.place, joint.other, hull).separation, own, false);
}

// The contact of least penetration that the chain allows: along the link's normal, or along a face of the hull whose
// normal exists at a joint. A hull that contains a joint also touches the neighbour, and may be left to it. `in_front`:
// whether the link's own face may push; if not, only a joint inside the hull does.
Manifold least_penetration(const Link& link, const Face& of_link, const Hull& hull, bool in_front, Real margin) {
  const Hull line = link.hull();
  Face allowed{-1, 0, in_front ? of_link.separation : -Shape::unbounded};
  for (int i = 0; i < hull.count; ++i) {
    const Face face = face_against(hull, i, line);
    const LinkEnd& joint = link.joint(face.support);
    if (joint.owner(-hull.normals[static_cast<std::size_t>(i)]) == Owner::nobody) continue;
    const bool reachable = in_front || contains(hull, joint.place);
    const bool better =
        allowed.edge < 0 ? beats(face.separation, allowed.separation, false) : face.separation > allowed.separation;
    if (reachable && better) allowed = face;
  }
  for (const LinkEnd* joint : {&link.start, &link.end}) {
    if (contains(hull, joint->place) && neighbour_pushes(*joint, hull, allowed.separation)) return {};
  }
  if (allowed.edge < 0) return in_front ? on_face(link, of_link, hull, margin) : Manifold{};
  const LinkEnd& joint = link.joint(allowed.support);
  const Owner owner = joint.owner(-hull.normals[static_cast<std::size_t>(allowed.edge)]);
  if (owner == Owner::neighbour && contains(hull, joint.place)) return {};
  return on_joint(link, allowed, hull, margin);
}

// If the cores don't overlap, the nearest points make the contact, unless their normal does not exist at the joint.
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
  // One-sided: a hull whose centre is behind the face is not pushed by it, but may rest on a joint until it is behind
  // entirely.
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
                                : least_penetration(link, of_link, hull, in_front, margin));
}

}  // namespace impulse::inline IMPULSE_PRECISION
