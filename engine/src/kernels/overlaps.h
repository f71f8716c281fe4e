#pragma once

#include <cstdint>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bounds as columns. Eight more entries than are meant must be readable after the last.
struct BoundsColumns {
  const Real* low_x;
  const Real* low_y;
  const Real* high_x;
  const Real* high_y;
};

/// From begin to before end.
struct Range {
  std::uint32_t begin, end;
};

/// Writes the numbers of all bounds in the ranges that overlap a box, range by range, and returns the end of the list.
/// There must be room for all that are in the ranges and eight more.
using FindOverlaps = std::uint32_t*(const BoundsColumns& among, const Aabb& box, const Range* ranges,
                                    const Range* ranges_end, std::uint32_t* to);

}  // namespace impulse::inline IMPULSE_PRECISION
