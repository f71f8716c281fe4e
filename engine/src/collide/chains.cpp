#include <cmath>
#include <limits>

#include "collide/colliders.h"
#include "collide/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();

// Whose business a contact normal at a joint is.
enum class Owner { self, neighbour, nobody };

// One end of a link, where it meets a neighbour. On an outward bend the normals from one face's to the other's are
// shared out at the middle; on a straight or inward joint no normals exist but those of the two faces, and a contact
// that would have another is a ghost.
struct Joint {
  Vec2 own, other;     // the two faces' normals
  Vec2 away;           // along this link, out over the joint
  bool bends_outward;  // or turns back at a free end

  Owner owner(Vec2 normal) const {
    const Real lean = dot(normal, away);
    if (lean < -rounding) return Owner::nobody;
    if (lean <= rounding && dot(normal, own) > 0) return Owner::self;
    if (!bends_outward) return Owner::nobody;
    const Real to_own = dot(normal, own);
    const Real to_other = dot(normal, other);
    const Real opening = dot(own, other) - rounding;
    if (to_own < opening || to_other < opening) return Owner::nobody;  // beyond one of the two
    return to_own >= to_other ? Owner::self : Owner::neighbour;
  }
};

Joint make_joint(Vec2 own, Vec2 away, Vec2 beyond) {
  const Vec2 onward = normalized(beyond);
  const Real turn = dot(own, onward);  // negative: the neighbour falls away from the free side
  const bool back = std::abs(turn) <= rounding && dot(away, onward) < 0;
  // The neighbour's normal stands to `onward` as `own` does to `away`.
  const Vec2 other = cross(away, own) > 0 ? perpendicular(onward) : -perpendicular(onward);
  return {own, other, away, turn < -rounding || back};
}

// A segment of a chain in its own frame.
struct Link {
  Edge face;
  Joint start, end;

  explicit Link(const Shape& segment) {
    const Vec2 n = segment.normal(0);
    const Vec2 t = perpendicular(n);
    const Vec2 from = segment.vertex(0);
    const Vec2 to = segment.vertex(1);
    // Links reach over their joints by a rounding, so that nothing falls between two.
    const Real reach = rounding * (std::abs(from.x) + std::abs(from.y) + std::abs(to.x) + std::abs(to.y));
    face = {from - reach * t, to + reach * t, n, 0, 1, 0};
    start = make_joint(n, -t, segment.ghost_before() - from);
    end = make_joint(n, t, segment.ghost_after() - to);
  }
  const Joint& joint(int vertex) const { return vertex == 0 ? start : end; }
  Hull hull() const {
    Hull line;
    line.count = 2;
    line.vertices = {face.from, face.to};
    line.normals = {face.normal, -face.normal};
    return line;
  }
};

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

// The hull's face separates better than the link's.
Manifold on_joint(const Link& link, const Face& link_face, const Face& face, const Hull& hull, Real margin) {
  const Edge reference = hull.edge(face.edge);
  const Joint& joint = link.joint(face.support);
  switch (joint.owner(-reference.normal)) {
    case Owner::neighbour:
      return {};
    case Owner::self: {
      const Real size = std::abs(link.face.from.x) + std::abs(link.face.from.y);
      const Manifold m = flipped(meet(reference, link.face, face.separation, size, margin));
      return joint.owner(m.normal) == Owner::self ? m : Manifold{};
    }
    case Owner::nobody:
      break;
  }
  // Beside an outward bend the neighbour pushes if it has less far to push.
  if (joint.bends_outward) {
    const Vec2 corner = face.support == 0 ? link.face.from : link.face.to;
    const Real beside = against_line(corner, joint.other, hull).separation;
    if (beats(beside, link_face.separation, true)) return {};
  }
  return on_face(link, link_face, hull, margin);
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
  if (dot(link.face.normal, hull.centroid - link.face.from) < 0) return {};
  const Real reach = margin + hull.radius;
  const Face of_link = against_line(link.face.from, link.face.normal, hull);
  if (of_link.separation > reach) return {};
  const Face of_hull = best_face(hull, link.hull());
  if (of_hull.separation > reach) return {};
  const Vec2 facing = hull.normals[static_cast<std::size_t>(of_hull.edge)];
  if (beats(of_hull.separation, of_link.separation, opposite(link.face.normal, facing))) {
    return to_world(pose_a, on_joint(link, of_link, of_hull, hull, margin));
  }
  return to_world(pose_a, on_face(link, of_link, hull, margin));
}

}  // namespace impulse::inline IMPULSE_PRECISION
