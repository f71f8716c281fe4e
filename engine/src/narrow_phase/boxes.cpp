#include <algorithm>
#include <cmath>

#include "narrow_phase/collide.h"
#include "narrow_phase/edges.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The frame with the box's centre as origin and its sides along the axes.
Rotation frame_of(const Shape& box, const Pose& pose) { return pose.q * Rotation(box.normal(1).x, box.normal(1).y); }

// The better of two opposite pairs of faces of one box.
struct BoxFace {
  bool across_x = false;  // its normal is along x
  Real separation = 0;
};

// h, other: half extents; there: the other's centre; (c, s): |cosine|, |sine| of the angle between the two.
BoxFace best_box_face(Vec2 h, Vec2 there, Real c, Real s, Vec2 other) {
  const Real x = std::abs(there.x) - (h.x + c * other.x + s * other.y);
  const Real y = std::abs(there.y) - (h.y + s * other.x + c * other.y);
  return x > y ? BoxFace{true, x} : BoxFace{false, y};
}

// The side of a box that faces a direction: 0 below, 1 right, 2 above, 3 left, as Shape::box numbers its edges.
int side_towards(Vec2 direction, bool along_x) {
  if (along_x) return direction.x > 0 ? 1 : 3;
  return direction.y > 0 ? 2 : 0;
}

Edge side(Vec2 h, int i) {
  switch (i) {
    case 0:
      return {{-h.x, -h.y}, {h.x, -h.y}, {0, -1}, 0, 1, 0};
    case 1:
      return {{h.x, -h.y}, {h.x, h.y}, {1, 0}, 1, 2, 0};
    case 2:
      return {{h.x, h.y}, {-h.x, h.y}, {0, 1}, 2, 3, 0};
    default:
      return {{-h.x, h.y}, {-h.x, -h.y}, {-1, 0}, 3, 0, 0};
  }
}

// In the frame of the box with the reference face.
Manifold against(Vec2 h, const BoxFace& face, Vec2 other, const Pose& there, Real margin) {
  const Edge reference = side(h, side_towards(there.p, face.across_x));
  const Vec2 facing = there.q.inverse() * -reference.normal;
  Edge incident = side(other, side_towards(facing, std::abs(facing.x) > std::abs(facing.y)));
  incident.from = to_world(there, incident.from);
  incident.to = to_world(there, incident.to);
  return meet(reference, incident, face.separation, h.x + h.y + other.x + other.y, margin);
}

}  // namespace

// Separating axes of oriented boxes (Gottschalk, Lin and Manocha, "OBBTree", 1996, in the plane): four axes, and on
// each the boxes' half lengths are sums of |cosine| and |sine| parts.
Manifold box_box(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin) {
  const Rotation frame_a = frame_of(a, pose_a);
  const Rotation frame_b = frame_of(b, pose_b);
  const Vec2 between = (pose_b.p - pose_a.p) + (pose_b.q * b.centroid() - pose_a.q * a.centroid());
  const Rotation turn = frame_a.inverse() * frame_b;
  const Real c = std::abs(turn.c);
  const Real s = std::abs(turn.s);
  const Vec2 h_a = a.half_extents();
  const Vec2 h_b = b.half_extents();

  const Pose b_from_a{frame_a.inverse() * between, turn};
  const BoxFace of_a = best_box_face(h_a, b_from_a.p, c, s, h_b);
  if (of_a.separation > margin) return {};
  const Pose a_from_b{frame_b.inverse() * -between, turn.inverse()};
  const BoxFace of_b = best_box_face(h_b, a_from_b.p, c, s, h_a);
  if (of_b.separation > margin) return {};

  const bool upright = std::min(c, s) < parallel;
  if (beats(of_b.separation, of_a.separation, upright)) {
    const Pose frame{to_world(pose_b, b.centroid()), frame_b};
    return to_world(frame, flipped(against(h_b, of_b, h_a, a_from_b, margin)));
  }
  const Pose frame{to_world(pose_a, a.centroid()), frame_a};
  return to_world(frame, against(h_a, of_a, h_b, b_from_a, margin));
}

}  // namespace impulse::inline IMPULSE_PRECISION
