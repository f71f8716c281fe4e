#include "broad_phase/lanes/overlaps.h"

#include "core/simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

/// within_reach() of one proxy and each lane; the depth is 0 if the proxy stands still.
struct Reach {
  Lanes low_x, low_y, high_x, high_y;
  Lanes displacement_x, displacement_y, displacement_length;
  bool still;

  Reach(const Aabb& box, const Displacement& displacement)
      : low_x(Lanes::all(box.low.x)),
        low_y(Lanes::all(box.low.y)),
        high_x(Lanes::all(box.high.x)),
        high_y(Lanes::all(box.high.y)),
        displacement_x(Lanes::all(displacement.by.x)),
        displacement_y(Lanes::all(displacement.by.y)),
        displacement_length(Lanes::all(displacement.length)),
        still(displacement.length == 0) {}

  Lanes depth(const BoundsColumns& among, std::uint32_t i) const {
    const Lanes x = displacement_x - Lanes::load(among.displacement_x + i);
    const Lanes y = displacement_y - Lanes::load(among.displacement_y + i);
    const Lanes both = displacement_length + Lanes::load(among.displacement_length + i);
    return max(both - both / Lanes::all(64) - sqrt(x * x + y * y), Lanes::all(0));
  }
  std::uint32_t met(const BoundsColumns& among, std::uint32_t i) const {
    const Lanes low_x_i = Lanes::load(among.low_x + i);
    const Lanes low_y_i = Lanes::load(among.low_y + i);
    const Lanes high_x_i = Lanes::load(among.high_x + i);
    const Lanes high_y_i = Lanes::load(among.high_y + i);
    if (still) {
      return ((low_x_i <= high_x) & (low_x <= high_x_i) & (low_y_i <= high_y) & (low_y <= high_y_i)).bits();
    }
    const Lanes deep = depth(among, i);
    return ((low_x_i + deep <= high_x) & (low_x + deep <= high_x_i) & (low_y_i + deep <= high_y) &
            (low_y + deep <= high_y_i))
        .bits();
  }
};

}  // namespace

// Most ranges hold a few proxies, so the first lanes are tested without checking whether the range is empty.
std::uint32_t* find_overlaps(const BoundsColumns& among, const Aabb& box, const Displacement& displacement,
                             const Range* ranges, const Range* ranges_end, std::uint32_t* to) {
  const Reach reach(box, displacement);
  for (const Range* range = ranges; range != ranges_end; ++range) {
    std::uint32_t i = range->begin;
    do {
      to = write_members(reach.met(among, i) & first_lanes(range->end - i), i, to);
      i += lane_count;
    } while (i < range->end);
  }
  return to;
}

std::uint32_t answer_batch(const BoundsColumns& among, const Query* queries, std::uint32_t count,
                           std::uint32_t* query_of, std::uint32_t* hit) {
  std::uint32_t* to = hit;
  for (std::uint32_t query = 0; query < count; ++query) {
    const auto [from, range] = queries[query];
    const Aabb box{{among.low_x[from], among.low_y[from]}, {among.high_x[from], among.high_y[from]}};
    const Displacement displacement{{among.displacement_x[from], among.displacement_y[from]},
                                    among.displacement_length[from]};
    const Reach reach(box, displacement);
    std::uint32_t i = range.begin;
    do {
      std::uint32_t* numbers = query_of + (to - hit);
      for (std::uint32_t lane = 0; lane < lane_count; ++lane) numbers[lane] = query;
      to = write_members(reach.met(among, i) & first_lanes(range.end - i), i, to);
      i += lane_count;
    } while (i < range.end);
  }
  return static_cast<std::uint32_t>(to - hit);
}

std::uint32_t filter_pairs(const Proxy* proxies, const Pair* pairs, std::uint32_t count, Pair* to) {
  std::uint32_t kept = 0;
  for (std::uint32_t from = 0; from < count; from += lane_count) {
    const std::uint32_t present = count - from;
    const Real* bounds_a[lane_count];
    const Real* bounds_b[lane_count];
    const Real* displacements_a[lane_count];
    const Real* displacements_b[lane_count];
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const Pair& pair = pairs[lane < present ? from + lane : from];
      bounds_a[lane] = &proxies[pair.first].bounds.low.x;
      bounds_b[lane] = &proxies[pair.second].bounds.low.x;
      displacements_a[lane] = &proxies[pair.first].displacement.by.x;
      displacements_b[lane] = &proxies[pair.second].displacement.by.x;
    }
    Lanes a[4];
    Lanes b[4];
    Lanes::gather(bounds_a, a);
    Lanes::gather(bounds_b, b);
    Lanes displacement_a[4];  // the fourth column is unused
    Lanes displacement_b[4];
    Lanes::gather(displacements_a, displacement_a);
    Lanes::gather(displacements_b, displacement_b);
    const Lanes x = displacement_a[0] - displacement_b[0];
    const Lanes y = displacement_a[1] - displacement_b[1];
    const Lanes both = displacement_a[2] + displacement_b[2];
    const Lanes deep = max(both - both / Lanes::all(64) - sqrt(x * x + y * y), Lanes::all(0));
    const auto met = (a[0] + deep <= b[2]) & (b[0] + deep <= a[2]) & (a[1] + deep <= b[3]) & (b[1] + deep <= a[3]);
    const std::uint32_t bits = met.bits();
    for (std::uint32_t lane = 0; lane < lane_count && lane < present; ++lane) {
      to[kept] = pairs[from + lane];
      kept += bits >> lane & 1U;
    }
  }
  return kept;
}

extern const BroadPhaseKernels broad_phase_table;
const BroadPhaseKernels broad_phase_table{find_overlaps, answer_batch, filter_pairs};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
