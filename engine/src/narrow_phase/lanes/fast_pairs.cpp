#include "narrow_phase/lanes/pair_lanes.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

// Tests the speed in any direction first, which needs no points: most pairs are slow.
std::uint32_t* find_fast(const PairBatch& batch, const PairPoints* found, const std::int8_t* counts,
                         std::uint32_t* to) {
  const Lanes time = Lanes::all(batch.time);
  const Lanes distance = Lanes::all(batch.distance);
  const Lanes least_distance = Lanes::all(batch.distance * (Real{63} / 64));  // 1/64 less, for rounding
  for (std::uint32_t from = 0; from < batch.count; from += lane_count) {
    const PairLanes pairs(batch, from);
    const PairLanes::Motion a = pairs.first_motion();
    const PairLanes::Motion b = pairs.second_motion();
    const Vec2Lanes between = b.velocity - a.velocity;
    const Lanes turning = a.rim + b.rim;
    const auto may_be_fast = least_distance < time * (abs(between.x) + abs(between.y) + turning);
    const std::uint32_t candidates = may_be_fast.bits() & pairs.present();
    if (candidates == 0) continue;
    const Real* rows[lane_count];
    std::uint32_t unknown = 0;
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const std::uint32_t item = pairs.item(lane < batch.count - from ? lane : 0);
      rows[lane] = found[item].normal;
      unknown |= (counts[item] < 0 ? 1U : 0U) << lane;
    }
    Lanes head[4];
    Lanes::gather(rows, head);
    const Vec2Lanes normal{head[0], head[1]};
    const auto fast = max(min(head[2], head[3]), distance) < time * (turning - dot(normal, between));
    to = pairs.leave(candidates & (fast.bits() | unknown), to);
  }
  return to;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
