#pragma once

#include <cstdint>

#include "broad_phase/broad_phase.h"
#include "core/instruction_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Lanes of the widest kernels.
constexpr std::uint32_t most_lanes = 16;

/// Bounds and displacements (see Proxy) as columns. At least most_lanes more entries than are used must be readable.
struct BoundsColumns {
  const Real* low_x;
  const Real* low_y;
  const Real* high_x;
  const Real* high_y;
  const Real* displacement_x;
  const Real* displacement_y;
  const Real* displacement_length;
};

/// From begin to before end.
struct Range {
  std::uint32_t begin, end;
};

/// Writes the indices of all bounds in the ranges that are within reach of a moving box, range by range, and returns
/// the end of the list. `to` needs room for every entry of the ranges and most_lanes more.
using FindOverlaps = std::uint32_t*(const BoundsColumns& among, const Aabb& box, const Displacement& displacement,
                                    const Range* ranges, const Range* ranges_end, std::uint32_t* to);

/// One query of a batch: which bounds of the range are within reach of the bounds at index `from`?
struct Query {
  std::uint32_t from;
  Range range;
};

/// Runs a batch of queries. For each hit, query by query, writes the index of the query and that of the bounds it
/// found; returns the number of hits. Both lists need room for every entry of the ranges and most_lanes more.
using AnswerBatch = std::uint32_t(const BoundsColumns& among, const Query* queries, std::uint32_t count,
                                  std::uint32_t* query_of, std::uint32_t* hit);

/// Copies the pairs that are within reach of each other, in order, and returns their number. `to` needs room for all.
using FilterPairs = std::uint32_t(const Proxy* proxies, const Pair* pairs, std::uint32_t count, Pair* to);

/// The kernels of the broad phase; they give the bits of within_reach().
struct BroadPhaseKernels {
  FindOverlaps* find_overlaps;
  AnswerBatch* answer_batch;
  FilterPairs* filter_pairs;
};
const BroadPhaseKernels& broad_phase_kernels(InstructionSet set = fastest_instruction_set());

}  // namespace impulse::inline IMPULSE_PRECISION
