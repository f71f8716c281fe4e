#include <limits>

#include "narrow_phase/lanes/manifolds.h"
#include "narrow_phase/lanes/pair_lanes.h"

// narrow_phase/boxes.cpp and narrow_phase/edges.h in lanes, operation by operation; their comments apply here too.
namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

using Mask = Lanes::Mask;

constexpr Real parallel = Real{1} / 128;                            // as in narrow_phase/edges.h
constexpr Real blur = 1024 * std::numeric_limits<Real>::epsilon();  // as in blurred() there

/// The better of two opposite pairs of faces of one box.
struct BoxFaces {
  Mask across_x;
  Lanes separation;
};

BoxFaces best_box_faces(const Vec2Lanes& h, const Vec2Lanes& there, const Lanes& c, const Lanes& s,
                        const Vec2Lanes& other) {
  const Lanes x = abs(there.x) - (h.x + c * other.x + s * other.y);
  const Lanes y = abs(there.y) - (h.y + s * other.x + c * other.y);
  const Mask across_x = y < x;
  return {across_x, select(across_x, x, y)};
}

/// Index of a side (see side() in narrow_phase/boxes.cpp), in the form that the signs of its corners need.
struct Side {
  Mask along_x;  // 1 or 3
  Mask ahead;    // 1 or 2

  Lanes first() const {
    return select(along_x, select(ahead, Lanes::all(1), Lanes::all(3)), select(ahead, Lanes::all(2), Lanes::all(0)));
  }
  Lanes second() const {
    return select(along_x, select(ahead, Lanes::all(2), Lanes::all(0)), select(ahead, Lanes::all(3), Lanes::all(1)));
  }
  // Sides 0, 1, 2, 3 start at corners (-, -), (+, -), (+, +), (-, +), and end where the next one starts.
  Vec2Lanes from(const Vec2Lanes& h) const {
    return {select(ahead, h.x, -h.x), select(select(along_x, !ahead, ahead), h.y, -h.y)};
  }
  Vec2Lanes to(const Vec2Lanes& h) const {
    return {select(along_x, select(ahead, h.x, -h.x), select(ahead, -h.x, h.x)), select(ahead, h.y, -h.y)};
  }
  Vec2Lanes normal() const {
    const Lanes one = select(ahead, Lanes::all(1), Lanes::all(-1));
    return {select(along_x, one, Lanes::all(0)), select(along_x, Lanes::all(0), one)};
  }
};

Side side_towards(const Vec2Lanes& direction, const Mask& along_x) {
  const Lanes zero = Lanes::all(0);
  return {along_x, select(along_x, zero < direction.x, zero < direction.y)};
}

struct EdgeLanes {
  Vec2Lanes from, to;
  Lanes first, second;  // corners
};

/// Points in the frame of the reference box, corners in order (reference, incident).
struct MeetingLanes {
  Vec2Lanes normal;
  Lanes separation[2];
  Vec2Lanes point[2];
  Lanes corner[2], incident_corner[2];
  Lanes count;
  Mask unsure;
};

struct OverlayLanes {
  Lanes length;
  Vec2Lanes low, high;

  OverlayLanes(const EdgeLanes& reference, const Vec2Lanes& n, const EdgeLanes& incident) {
    const Vec2Lanes t = perpendicular(n);
    const Vec2Lanes to = incident.to - reference.from;
    const Vec2Lanes from = incident.from - reference.from;
    length = dot(reference.to - reference.from, t);
    low = {dot(to, t), dot(to, n)};
    high = {dot(from, t), dot(from, n)};
  }
  Mask overlaps() const { return (low.x <= length) & (Lanes::all(0) <= high.x); }
  Lanes height(const Lanes& x) const {
    const Lanes run = high.x - low.x;
    return select(Lanes::all(0) < run, low.y + (x - low.x) / run * (high.y - low.y), min(low.y, high.y));
  }
};

/// Replaces what clip() found by touch() in the lanes where two corners are nearest to each other.
void touch_corners(const EdgeLanes& reference, const EdgeLanes& incident, const OverlayLanes& over,
                   const Mask& apart_at_all, const Lanes& least, const Lanes& margin, MeetingLanes& m) {
  const Lanes zero = Lanes::all(0);
  const Mask overlaps = over.overlaps();
  const auto beyond = [&](const Lanes& x) { return !((zero <= x) & (x <= over.length)); };
  const Lanes nearer = select(over.low.y < over.high.y, over.low.x, over.high.x);
  const Vec2Lanes run = over.high - over.low;
  const Mask faces = overlaps & (abs(run.y) <= Lanes::all(parallel) * run.x);
  const Mask at_start = select(overlaps, nearer < zero, over.high.x < zero);
  const Vec2Lanes corner{select(at_start, zero, over.length), zero};
  const Lanes place = dot(corner - over.low, run);
  const Mask between = (zero < place) & (place < length_squared(run));
  const Mask low_end = place <= zero;
  const Mask closest =
      apart_at_all & beyond(nearer) & !faces & !between & beyond(select(low_end, over.low.x, over.high.x));
  const Vec2Lanes a = select(at_start, reference.from, reference.to);
  const Vec2Lanes apart = select(low_end, incident.to, incident.from) - a;
  const Mask touching = closest & (least * least < length_squared(apart));
  if (touching.bits() == 0) return;

  const Lanes distance = length(apart);
  const Vec2Lanes normal = apart / distance;
  const Lanes separation = distance - zero - zero;
  const Lanes middle = zero + separation / Lanes::all(2);
  m.normal = select(touching, normal, m.normal);
  m.separation[0] = select(touching, separation, m.separation[0]);
  m.point[0] = select(touching, a + middle * normal, m.point[0]);
  m.corner[0] = select(touching, select(at_start, reference.first, reference.second), m.corner[0]);
  m.incident_corner[0] = select(touching, select(low_end, incident.second, incident.first), m.incident_corner[0]);
  m.count = select(touching, select(margin < separation, zero, Lanes::all(1)), m.count);
}

/// meet(); unsure in the lanes where it would need add_deepest().
MeetingLanes meet(const EdgeLanes& reference, const Vec2Lanes& n, const EdgeLanes& incident, const Lanes& separation,
                  const Lanes& size, const Lanes& margin) {
  const Lanes zero = Lanes::all(0);
  const Lanes one = Lanes::all(1);
  const OverlayLanes over(reference, n, incident);
  const Mask overlaps = over.overlaps();

  const Vec2Lanes start{zero, over.height(zero)};
  const Vec2Lanes end{over.length, over.height(over.length)};
  const Vec2Lanes place[2] = {select(over.low.x < zero, start, over.low),
                              select(over.length < over.high.x, end, over.high)};
  const Vec2Lanes t = perpendicular(n);
  MeetingLanes m;
  m.normal = n;
  Mask reported[2];
  for (std::uint32_t p = 0; p < 2; ++p) {
    m.separation[p] = place[p].y - zero - zero;
    reported[p] = overlaps & !(margin < m.separation[p]);
    const Lanes middle = zero + m.separation[p] / Lanes::all(2);
    m.point[p] = reference.from + place[p].x * t + middle * n;
  }
  m.corner[0] = reference.first;
  m.corner[1] = reference.second;
  m.incident_corner[0] = incident.second;
  m.incident_corner[1] = incident.first;
  m.separation[0] = select(reported[0], m.separation[0], m.separation[1]);
  m.point[0] = select(reported[0], m.point[0], m.point[1]);
  m.corner[0] = select(reported[0], m.corner[0], m.corner[1]);
  m.incident_corner[0] = select(reported[0], m.incident_corner[0], m.incident_corner[1]);
  m.count = select(reported[0], one, zero) + select(reported[1], one, zero);

  const Lanes least = Lanes::all(blur) * size;
  const Mask apart_at_all = (zero < separation) | ((-least < separation) & !overlaps);
  if (apart_at_all.bits() != 0) touch_corners(reference, incident, over, apart_at_all, least, margin, m);
  m.unsure = (m.count == zero) & (separation <= zero);
  return m;
}

/// The frame of a reference box and the other box in it.
struct Against {
  Vec2Lanes center;
  RotationLanes frame;
  Vec2Lanes size, other;
  BoxFaces faces;
  Vec2Lanes there;     // the other's centre
  RotationLanes turn;  // of the other
};

MeetingLanes against(const Against& it, const Lanes& margin) {
  const Side reference_side = side_towards(it.there, it.faces.across_x);
  const Vec2Lanes n = reference_side.normal();
  const EdgeLanes reference{reference_side.from(it.size), reference_side.to(it.size), reference_side.first(),
                            reference_side.second()};
  const Vec2Lanes facing = it.turn.inverse() * -n;
  const Side side = side_towards(facing, abs(facing.y) < abs(facing.x));
  const EdgeLanes incident{it.there + it.turn * side.from(it.other), it.there + it.turn * side.to(it.other),
                           side.first(), side.second()};
  return meet(reference, n, incident, it.faces.separation, it.size.x + it.size.y + it.other.x + it.other.y, margin);
}

/// beats()
Mask second_beats(const Lanes& second, const Lanes& first, const Mask& upright) {
  const Lanes by_depth = select(Lanes::all(0) < first, first, first - first / Lanes::all(64));
  return select(upright, by_depth + Lanes::all(static_cast<Real>(1e-4)), first) < second;
}

}  // namespace

std::uint32_t* collide_boxes(const PairBatch& batch, PairPoints* found, std::uint32_t* left) {
  const Lanes zero = Lanes::all(0);
  for (std::uint32_t from = 0; from < batch.count; from += lane_count) {
    const PairLanes pairs(batch, from);
    const ShapeLanes a = pairs.first();
    const ShapeLanes b = pairs.second();
    const Lanes margin = pairs.margin();

    const OrderLanes order((b.position - a.position) + (b.offset - a.offset));
    const Mask swapped = order.swapped;
    const ShapeLanes one = select(swapped, b, a);
    const ShapeLanes two = select(swapped, a, b);

    const Vec2Lanes between = (two.position - one.position) + (two.offset - one.offset);
    const RotationLanes turn = one.turn.inverse() * two.turn;
    const Lanes c = abs(turn.c);
    const Lanes s = abs(turn.s);
    const Vec2Lanes two_from_one = one.turn.inverse() * between;
    const Vec2Lanes one_from_two = two.turn.inverse() * -between;
    const BoxFaces of_one = best_box_faces(one.size, two_from_one, c, s, two.size);
    const BoxFaces of_two = best_box_faces(two.size, one_from_two, c, s, one.size);
    const Mask apart = (margin < of_one.separation) | (margin < of_two.separation);
    if ((~(apart & order.known).bits() & pairs.present()) == 0) {
      pairs.clear(found);
      continue;
    }

    const Mask upright = min(c, s) < Lanes::all(parallel);
    const Mask second = second_beats(of_two.separation, of_one.separation, upright);
    const MeetingLanes m = against(
        {select(second, two.position + two.offset, one.position + one.offset),
         select(second, two.turn, one.turn),
         select(second, two.size, one.size),
         select(second, one.size, two.size),
         {select(second, of_two.across_x, of_one.across_x), select(second, of_two.separation, of_one.separation)},
         select(second, one_from_two, two_from_one),
         select(second, turn.inverse(), turn)},
        margin);

    const RotationLanes frame = select(second, two.turn, one.turn);
    const Vec2Lanes center = select(second, two.position + two.offset, one.position + one.offset);
    const Vec2Lanes normal = frame * select(second, -m.normal, m.normal);
    PointsLanes points;
    points.normal = select(swapped, -normal, normal);
    const Mask reference_is_a = select(second, swapped, !swapped);
    const Lanes four = Lanes::all(4);
    Lanes code[2];
    for (std::uint32_t p = 0; p < 2; ++p) {
      points.separation[p] = m.separation[p];
      points.point[p] = center + frame * m.point[p];
      code[p] =
          select(reference_is_a, m.corner[p] + four * m.incident_corner[p], m.incident_corner[p] + four * m.corner[p]);
    }
    const Lanes count = select(apart, zero, m.count);
    points.code = count + four * (code[0] + Lanes::all(16) * code[1]);
    points.write(pairs, a.position, b.position, found);
    left = pairs.leave(((m.unsure & !apart) | !order.known).bits(), left);
  }
  return left;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
