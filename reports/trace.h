#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// The recording of a run: the state of every body before the first step and after each step, and the contacts of each
/// step. A moment is the index of a recording; 0 is the start.
class Trace {
 public:
  explicit Trace(std::size_t bodies) : bodies_(bodies) {}

  /// Makes room for the states of so many moments at once.
  void reserve(std::size_t moments);
  /// Throws std::invalid_argument unless there is one state per body and `time`, s, is later than the last.
  void record(double time, std::span<const BodyState> states, std::span<const ContactState> contacts);

  std::size_t bodies() const { return bodies_; }
  std::size_t size() const { return times_.size(); }  // recorded moments: steps + 1
  double time(std::size_t moment) const { return times_[moment]; }
  std::span<const double> times() const { return times_; }
  std::span<const BodyState> states(std::size_t moment) const;
  std::span<const ContactState> contacts(std::size_t moment) const;

  /// Whether the engine reported a contact at any moment.
  bool has_contacts() const { return !contacts_.empty(); }

  /// The moments before and after a time, and how far between them it lies, 0 ... 1. A time before the first or after
  /// the last moment gives that moment twice. Throws std::invalid_argument if nothing is recorded.
  struct Bracket {
    std::size_t before, after;
    double fraction;
  };
  Bracket bracket(double time) const;

  /// The state at a time, interpolated linearly between moments, as the scene format specifies.
  BodyState state_at(std::size_t body, double time) const;

 private:
  std::size_t bodies_;
  std::vector<double> times_;
  std::vector<BodyState> states_;         // moment-major
  std::vector<ContactState> contacts_;    // moment by moment
  std::vector<std::size_t> contact_end_;  // end of each moment's contacts
};

/// Of every bit of it.
std::uint64_t hash_of(const Trace&);

}  // namespace plumb
