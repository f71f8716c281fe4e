#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bounds to be searched, many at a time, with the ways of what they hold (see Proxy).
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
  void set(std::uint32_t i, const Aabb& bounds, const Way& way) {
    held_[0][i] = bounds.low.x;
    held_[1][i] = bounds.low.y;
    held_[2][i] = bounds.high.x;
    held_[3][i] = bounds.high.y;
    held_[4][i] = way.by.x;
    held_[5][i] = way.by.y;
    held_[6][i] = way.length;
  }
  Aabb bounds(std::uint32_t i) const { return {{held_[0][i], held_[1][i]}, {held_[2][i], held_[3][i]}}; }
  Way way(std::uint32_t i) const { return {{held_[4][i], held_[5][i]}, held_[6][i]}; }

  /// Which of those in some ranges are within reach of the box, range by range. Valid until the next search.
  std::span<const std::uint32_t> within_reach(const Aabb& box, const Way& way, std::initializer_list<Range> ranges) {
    std::size_t room = most_lanes;
    for (const Range& range : ranges) room += range.end - range.begin;
    if (found_.size() < room) found_.resize(2 * room);
    return {found_.data(), find_overlaps_(columns_, box, way, ranges.begin(), ranges.end(), found_.data())};
  }

  /// Calls met(question, other) for each who answers a question, by the number of the question, in their order.
  template <class Met>
  void answer(std::span<const Question> questions, const Met& met) {
    for (std::uint32_t first = 0; first < questions.size();) {
      std::size_t room = most_lanes;
      std::uint32_t end = first;
      for (; end < questions.size() && room < most_at_once; ++end) {
        room += questions[end].range.end - questions[end].range.begin;
      }
      if (found_.size() < room) found_.resize(2 * room);
      if (question_of_.size() < room) question_of_.resize(2 * room);
      const std::uint32_t count =
          answer_questions_(columns_, &questions[first], end - first, question_of_.data(), found_.data());
      for (std::uint32_t i = 0; i < count; ++i) met(first + question_of_[i], found_[i]);
      first = end;
    }
  }

 private:
  static constexpr std::size_t most_at_once = 1U << 14U;  // answers that may have to be kept meanwhile

  std::array<std::vector<Real>, 7> held_;
  BoundsColumns columns_{};
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> question_of_;
  AnswerQuestions* answer_questions_ = kernels().answer_questions;
  FindOverlaps* find_overlaps_ = kernels().find_overlaps;
};

}  // namespace impulse::inline IMPULSE_PRECISION
