#pragma once

#include <cmath>
#include <limits>

#include "shapes/hull.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Leans below this are rounding.
constexpr Real joint_rounding = 64 * std::numeric_limits<Real>::epsilon();

/// Whose business a contact normal at a joint is.
enum class Owner { self, neighbour, nobody };

/// One end of a link, where it meets a neighbour. On an outward bend the normals from one face's to the other's are
/// shared out at the middle; on a straight or inward joint no normals exist but those of the two faces, and a contact
/// that would have another is a ghost.
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

inline LinkEnd make_link_end(Vec2 place, Vec2 own, Vec2 away, Vec2 beyond) {
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
    // Links reach over their joints by a few roundings, so that nothing falls between two.
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

}  // namespace impulse::inline IMPULSE_PRECISION
