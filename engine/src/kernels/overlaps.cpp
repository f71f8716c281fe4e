#include "kernels/overlaps.h"

#include "simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

/// The first n lanes.
std::uint32_t first_lanes(std::uint32_t n) { return n < lane_count ? ~(~0U << n) : 0xffU; }

}  // namespace

// Most ranges hold a few: the first eight are tested without asking whether there are any.
std::uint32_t* find_overlaps(const BoundsColumns& among, const Aabb& box, const Range* ranges, const Range* ranges_end,
                             std::uint32_t* to) {
  const Lanes low_x = Lanes::all(box.low.x);
  const Lanes low_y = Lanes::all(box.low.y);
  const Lanes high_x = Lanes::all(box.high.x);
  const Lanes high_y = Lanes::all(box.high.y);
  for (const Range* range = ranges; range != ranges_end; ++range) {
    std::uint32_t i = range->begin;
    do {
      const auto overlap = (Lanes::load(among.low_x + i) <= high_x) & (low_x <= Lanes::load(among.high_x + i)) &
                           (Lanes::load(among.low_y + i) <= high_y) & (low_y <= Lanes::load(among.high_y + i));
      to = write_members(overlap.bits() & first_lanes(range->end - i), i, to);
      i += lane_count;
    } while (i < range->end);
  }
  return to;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
