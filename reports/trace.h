#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// What a run left behind: the state of every body before the first step and after each one, and the contacts of each
/// step.
class Trace {
 public:
  explicit Trace(std::size_t bodies) : bodies_(bodies) {}

  /// Throws std::invalid_argument unless there is a state for every body and time has advanced.
  void record(double time, std::span<const BodyState> states, std::span<const ContactState> contacts);

  std::size_t bodies() const { return bodies_; }
  std::size_t size() const { return times_.size(); }  // recorded moments: steps + 1
  double time(std::size_t moment) const { return times_[moment]; }
  std::span<const double> times() const { return times_; }
  std::span<const BodyState> states(std::size_t moment) const;
  std::span<const ContactState> contacts(std::size_t moment) const;

  /// The two moments on either side of a time and how far between them it lies, 0 ... 1. Before the first and after the
  /// last recorded moment: that moment itself. Throws std::invalid_argument when nothing is recorded.
  struct Between {
    std::size_t before, after;
    double share;
  };
  Between around(double time) const;

  /// The state at a time, interpolated linearly between steps (as the scene format says a reading is).
  BodyState state_at(std::size_t body, double time) const;

 private:
  std::size_t bodies_;
  std::vector<double> times_;
  std::vector<BodyState> states_;         // moment-major
  std::vector<ContactState> contacts_;    // all moments in turn
  std::vector<std::size_t> contact_end_;  // end of each moment's contacts
};

}  // namespace plumb
