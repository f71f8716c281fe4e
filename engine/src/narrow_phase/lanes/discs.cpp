#include "narrow_phase/lanes/manifolds.h"
#include "narrow_phase/lanes/pair_lanes.h"

// narrow_phase/circles.cpp in lanes, operation by operation.
namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

using Mask = Lanes::Mask;

/// round_contact(): in the frame of the other shape; `outward` is its normal towards the disc's centre.
struct RoundContact {
  Vec2Lanes normal;
  Vec2Lanes point;
  Lanes separation;

  RoundContact(const Vec2Lanes& center, const Lanes& radius, const Vec2Lanes& outward, const Lanes& gap)
      : normal(-outward), point(center - (radius + gap / Lanes::all(2)) * outward), separation(gap) {}
};

void write(const PairLanes& pairs, const RoundContact& contact, const Vec2Lanes& center, const RotationLanes& frame,
           const Vec2Lanes& normal, const Vec2Lanes& center_a, const Vec2Lanes& center_b, const Lanes& margin,
           PairPoints* found) {
  const Vec2Lanes point = center + frame * contact.point;
  const Lanes count = select(contact.separation <= margin, Lanes::all(1), Lanes::all(0));
  const PointsLanes points{normal, {contact.separation, contact.separation}, {point, point}, count};
  points.write(pairs, center_a, center_b, found);
}

/// circle_box()
template <bool disc_first>
std::uint32_t* collide_mixed(const PairBatch& batch, PairPoints* found, std::uint32_t* left) {
  const Lanes zero = Lanes::all(0);
  const Lanes one = Lanes::all(1);
  for (std::uint32_t from = 0; from < batch.count; from += lane_count) {
    const PairLanes pairs(batch, from);
    const ShapeLanes a = pairs.first();
    const ShapeLanes b = pairs.second();
    const ShapeLanes& disc = disc_first ? a : b;
    const ShapeLanes& box = disc_first ? b : a;

    const Vec2Lanes between = (disc.position - box.position) + (disc.turn * disc.offset - box.offset);
    const Vec2Lanes center = box.turn.inverse() * between;
    const Vec2Lanes h = box.size;
    const auto clamped = [](const Lanes& x, const Lanes& most) {
      return select(x < -most, -most, select(most < x, most, x));
    };
    const Vec2Lanes nearest{clamped(center.x, h.x), clamped(center.y, h.y)};
    const Mask inside = (nearest.x == center.x) & (nearest.y == center.y);

    const Vec2Lanes apart = center - nearest;
    const Lanes distance = length(apart);
    const Mask direction_known = zero < distance;
    const Vec2Lanes direction = apart / distance;
    const Lanes out_x = abs(center.x) - h.x;
    const Lanes out_y = abs(center.y) - h.y;
    const Mask through_x = out_y < out_x;
    const Vec2Lanes nearest_side{select(through_x, select(center.x < zero, -one, one), zero),
                                 select(through_x, zero, select(center.y < zero, -one, one))};
    const Vec2Lanes outward = select(inside, nearest_side, select(direction_known, direction, Vec2Lanes{zero, zero}));
    const Lanes gap = select(inside, max(out_x, out_y) - disc.size.x, distance - disc.size.x - zero);

    const RoundContact contact(center, disc.size.x, outward, gap);
    const Vec2Lanes normal = box.turn * contact.normal;
    write(pairs, contact, box.position + box.offset, box.turn, disc_first ? normal : -normal, a.position, b.position,
          pairs.margin(), found);
  }
  return left;
}

}  // namespace

std::uint32_t* collide_disc_with_box(const PairBatch& batch, PairPoints* found, std::uint32_t* left) {
  return collide_mixed<true>(batch, found, left);
}

std::uint32_t* collide_box_with_disc(const PairBatch& batch, PairPoints* found, std::uint32_t* left) {
  return collide_mixed<false>(batch, found, left);
}

/// circle_circle(), in the frame of the second in order.
std::uint32_t* collide_discs(const PairBatch& batch, PairPoints* found, std::uint32_t* left) {
  for (std::uint32_t from = 0; from < batch.count; from += lane_count) {
    const PairLanes pairs(batch, from);
    const ShapeLanes a = pairs.first();
    const ShapeLanes b = pairs.second();
    const OrderLanes order((b.position - a.position) + (b.turn * b.offset - a.turn * a.offset));
    const ShapeLanes one = select(order.swapped, b, a);
    const ShapeLanes two = select(order.swapped, a, b);

    const Vec2Lanes one_from_two = two.turn.inverse() * (one.position - two.position);
    const Vec2Lanes center = one_from_two + (two.turn.inverse() * one.turn) * one.offset;
    const Vec2Lanes apart = center - two.offset;
    const Lanes distance = length(apart);
    const Vec2Lanes outward =
        select(Lanes::all(0) < distance, apart / distance, Vec2Lanes{Lanes::all(0), Lanes::all(-1)});
    const RoundContact contact(center, one.size.x, outward, distance - one.size.x - two.size.x);
    const Vec2Lanes normal = two.turn * contact.normal;
    write(pairs, contact, two.position, two.turn, select(order.swapped, -normal, normal), a.position, b.position,
          pairs.margin(), found);
    left = pairs.leave((!order.known).bits(), left);
  }
  return left;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
