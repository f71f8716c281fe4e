#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bounds to be searched, eight at a time.
class BoundsTable {
 public:
  BoundsTable() = default;
  BoundsTable(const BoundsTable&) = delete;  // columns_ points into it
  BoundsTable& operator=(const BoundsTable&) = delete;

  void resize(std::size_t count) {
    for (std::vector<Real>* column : {&low_x_, &low_y_, &high_x_, &high_y_}) column->resize(count + 8);
    columns_ = {low_x_.data(), low_y_.data(), high_x_.data(), high_y_.data()};
  }
  void set(std::uint32_t i, const Aabb& bounds) {
    low_x_[i] = bounds.low.x;
    low_y_[i] = bounds.low.y;
    high_x_[i] = bounds.high.x;
    high_y_[i] = bounds.high.y;
  }
  Aabb at(std::uint32_t i) const { return {{low_x_[i], low_y_[i]}, {high_x_[i], high_y_[i]}}; }

  /// Which of those in some ranges overlap the box, range by range. Valid until the next search.
  std::span<const std::uint32_t> overlapping(const Aabb& box, std::initializer_list<Range> ranges) {
    std::size_t room = 8;
    for (const Range& range : ranges) room += range.end - range.begin;
    if (found_.size() < room) found_.resize(2 * room);
    return {found_.data(), find_overlaps_(columns_, box, ranges.begin(), ranges.end(), found_.data())};
  }

 private:
  std::vector<Real> low_x_, low_y_, high_x_, high_y_;
  BoundsColumns columns_{};
  std::vector<std::uint32_t> found_;
  FindOverlaps* find_overlaps_ = kernels().find_overlaps;
};

}  // namespace impulse::inline IMPULSE_PRECISION
