#include "broad_phase/lanes/overlaps.h"

#include "core/simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

/// within_reach() of each lane and one; the depth is 0 where the one stands still.
struct Reach {
  Lanes low_x, low_y, high_x, high_y;
  Lanes way_x, way_y, way_length;
  bool still;

  Reach(const Aabb& box, const Way& way)
      : low_x(Lanes::all(box.low.x)),
        low_y(Lanes::all(box.low.y)),
        high_x(Lanes::all(box.high.x)),
        high_y(Lanes::all(box.high.y)),
        way_x(Lanes::all(way.by.x)),
        way_y(Lanes::all(way.by.y)),
        way_length(Lanes::all(way.length)),
        still(way.length == 0) {}

  Lanes depth(const BoundsColumns& among, std::uint32_t i) const {
    const Lanes x = way_x - Lanes::load(among.way_x + i);
    const Lanes y = way_y - Lanes::load(among.way_y + i);
    const Lanes both = way_length + Lanes::load(among.way_length + i);
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

// Most ranges hold a few: the first lanes are tested without asking whether there are any.
std::uint32_t* find_overlaps(const BoundsColumns& among, const Aabb& box, const Way& way, const Range* ranges,
                             const Range* ranges_end, std::uint32_t* to) {
  const Reach reach(box, way);
  for (const Range* range = ranges; range != ranges_end; ++range) {
    std::uint32_t i = range->begin;
    do {
      to = write_members(reach.met(among, i) & first_lanes(range->end - i), i, to);
      i += lane_count;
    } while (i < range->end);
  }
  return to;
}

std::uint32_t answer_questions(const BoundsColumns& among, const Question* questions, std::uint32_t count,
                               std::uint32_t* question_of, std::uint32_t* answer) {
  std::uint32_t* to = answer;
  for (std::uint32_t question = 0; question < count; ++question) {
    const auto [asker, range] = questions[question];
    const Aabb box{{among.low_x[asker], among.low_y[asker]}, {among.high_x[asker], among.high_y[asker]}};
    const Way way{{among.way_x[asker], among.way_y[asker]}, among.way_length[asker]};
    const Reach reach(box, way);
    std::uint32_t i = range.begin;
    do {
      std::uint32_t* numbers = question_of + (to - answer);
      for (std::uint32_t lane = 0; lane < lane_count; ++lane) numbers[lane] = question;
      to = write_members(reach.met(among, i) & first_lanes(range.end - i), i, to);
      i += lane_count;
    } while (i < range.end);
  }
  return static_cast<std::uint32_t>(to - answer);
}

std::uint32_t filter_pairs(const Proxy* proxies, const Pair* pairs, std::uint32_t count, Pair* to) {
  std::uint32_t kept = 0;
  for (std::uint32_t from = 0; from < count; from += lane_count) {
    const std::uint32_t present = count - from;
    const Real* bounds_a[lane_count];
    const Real* bounds_b[lane_count];
    const Real* ways_a[lane_count];
    const Real* ways_b[lane_count];
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const Pair& pair = pairs[lane < present ? from + lane : from];
      bounds_a[lane] = &proxies[pair.first].bounds.low.x;
      bounds_b[lane] = &proxies[pair.second].bounds.low.x;
      ways_a[lane] = &proxies[pair.first].way.by.x;
      ways_b[lane] = &proxies[pair.second].way.by.x;
    }
    Lanes a[4];
    Lanes b[4];
    Lanes::gather(bounds_a, a);
    Lanes::gather(bounds_b, b);
    Lanes way_a[4];  // the last of four is not asked for
    Lanes way_b[4];
    Lanes::gather(ways_a, way_a);
    Lanes::gather(ways_b, way_b);
    const Lanes x = way_a[0] - way_b[0];
    const Lanes y = way_a[1] - way_b[1];
    const Lanes both = way_a[2] + way_b[2];
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

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
