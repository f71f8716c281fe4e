#pragma once

#include <algorithm>
#include <cstddef>

namespace plumb {

/// How many steps a program is asked for at once. Many, for asking and waking up take longer than many a step; but no
/// more than are soon answered, so that a program that sends all its answers together is not taken to hang.
class StepsAhead {
 public:
  std::size_t count() const { return count_; }

  /// That many were asked for, and answered within that many seconds.
  void took(std::size_t steps, double seconds) {
    if (seconds > soon) count_ = least;
    if (seconds <= soon && steps == count_) count_ = std::min(2 * count_, most);
  }

 private:
  static constexpr std::size_t least = 64, most = 512;
  static constexpr double soon = 0.02;  // s

  std::size_t count_ = least;
};

}  // namespace plumb
