#pragma once

#include <cstdint>

#include "broad_phase/broad_phase.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Lanes of the widest kernels.
constexpr std::uint32_t most_lanes = 16;

/// Bounds and ways (see Proxy) as columns. Most_lanes more entries than are meant must be readable after the last.
struct BoundsColumns {
  const Real* low_x;
  const Real* low_y;
  const Real* high_x;
  const Real* high_y;
  const Real* way_x;
  const Real* way_y;
  const Real* way_length;
};

/// From begin to before end.
struct Range {
  std::uint32_t begin, end;
};

/// Writes the numbers of all bounds in the ranges that are within reach of a box that goes its way, range by range, and
/// returns the end of the list. There must be room for all that are in the ranges and most_lanes more.
using FindOverlaps = std::uint32_t*(const BoundsColumns& among, const Aabb& box, const Way& way, const Range* ranges,
                                    const Range* ranges_end, std::uint32_t* to);

/// Who in the range is within reach of the asker, which is among the bounds itself?
struct Question {
  std::uint32_t asker;
  Range range;
};

/// Answers some questions: for each answer, question by question, the number of the question and of who it is. Returns
/// how many answers there are. There must be room for all that are in the ranges and most_lanes more.
using AnswerQuestions = std::uint32_t(const BoundsColumns& among, const Question* questions, std::uint32_t count,
                                      std::uint32_t* question_of, std::uint32_t* answer);

/// Writes those of some pairs that are within reach of each other, in their order, and returns how many. There must be
/// room for all.
using FilterPairs = std::uint32_t(const Proxy* proxies, const Pair* pairs, std::uint32_t count, Pair* to);

}  // namespace impulse::inline IMPULSE_PRECISION
