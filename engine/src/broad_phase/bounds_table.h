#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "broad_phase/lanes/overlaps.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bounds and displacements (see Proxy) in columns, which kernels search many at a time.
class BoundsTable {
 public:
  BoundsTable() = default;
  BoundsTable(const BoundsTable&) = delete;  // columns_ points into it
  BoundsTable& operator=(const BoundsTable&) = delete;

  void resize(std::size_t count) {
    for (std::vector<Real>& column : held_) column.resize(count + most_lanes);
    columns_ = {held_[0].data(), held_[1].data(), held_[2].data(), held_[3].data(),
                held_[4].data(), held_[5].data(), held_[6].data()};
  }
  void set(std::uint32_t i, const Aabb& bounds, const Displacement& displacement) {
    held_[0][i] = bounds.low.x;
    held_[1][i] = bounds.low.y;
    held_[2][i] = bounds.high.x;
    held_[3][i] = bounds.high.y;
    held_[4][i] = displacement.by.x;
    held_[5][i] = displacement.by.y;
    held_[6][i] = displacement.length;
  }
  Aabb bounds(std::uint32_t i) const { return {{held_[0][i], held_[1][i]}, {held_[2][i], held_[3][i]}}; }
  Displacement displacement(std::uint32_t i) const { return {{held_[4][i], held_[5][i]}, held_[6][i]}; }

  /// The indices of the entries in some ranges that are within reach of the box, range by range. Valid until the next
  /// search.
  std::span<const std::uint32_t> within_reach(const Aabb& box, const Displacement& displacement,
                                              std::initializer_list<Range> ranges) {
    std::size_t capacity = most_lanes;
    for (const Range& range : ranges) capacity += range.end - range.begin;
    if (found_.size() < capacity) found_.resize(2 * capacity);
    return {found_.data(), find_overlaps_(columns_, box, displacement, ranges.begin(), ranges.end(), found_.data())};
  }

  /// Calls met(query, other) for each hit of each query, in order; `query` is the index of the query.
  template <class Met>
  void answer(std::span<const Query> queries, const Met& met) {
    for (std::uint32_t first = 0; first < queries.size();) {
      std::size_t capacity = most_lanes;
      std::uint32_t end = first;
      for (; end < queries.size() && capacity < batch_capacity; ++end) {
        capacity += queries[end].range.end - queries[end].range.begin;
      }
      if (found_.size() < capacity) found_.resize(2 * capacity);
      if (query_of_.size() < capacity) query_of_.resize(2 * capacity);
      const std::uint32_t count =
          answer_batch_(columns_, &queries[first], end - first, query_of_.data(), found_.data());
      for (std::uint32_t i = 0; i < count; ++i) met(first + query_of_[i], found_[i]);
      first = end;
    }
  }

 private:
  static constexpr std::size_t batch_capacity = 1U << 14U;  // hits to store at once; a batch ends when it may have more

  std::array<std::vector<Real>, 7> held_;
  BoundsColumns columns_{};
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> query_of_;
  AnswerBatch* answer_batch_ = broad_phase_kernels().answer_batch;
  FindOverlaps* find_overlaps_ = broad_phase_kernels().find_overlaps;
};

}  // namespace impulse::inline IMPULSE_PRECISION
