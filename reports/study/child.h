#pragma once

#include <sys/types.h>

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reports/study/point.h"
#include "reports/timing/repetitions.h"

namespace plumb {

/// What a point may take before it is ended.
struct Limits {
  double seconds = 60;      // for its run, and for each of its turns
  double mebibytes = 4096;  // of memory in use
};

/// A process that finds out one point. Only a process without other threads may have children.
class Child {
 public:
  /// Begins at once. The point must outlive it.
  explicit Child(const Point&);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// It is at work.
  bool busy() const { return busy_; }
  /// It has run and can take a turn.
  bool ready() const { return process_ > 0 && !busy_; }
  /// Asks for a turn of one that is ready.
  void take_turn();

  const Point& point() const { return point_; }
  const PointResult& result() const { return result_; }
  /// Its turns so far.
  const Repetitions& repetitions() const { return repetitions_; }

  /// Waits a moment for the busy ones among these, takes in what they say, and ends those beyond their limits.
  static void attend(std::span<const std::unique_ptr<Child>>, const Limits&);

 private:
  using Clock = std::chrono::steady_clock;

  void listen();
  void hear(const std::string& line);
  void check(const Limits&);
  double waited() const;
  void end(Ending, const std::string& reason);
  void bury();

  const Point& point_;
  PointResult result_;
  pid_t process_ = 0;
  int from_ = -1, to_ = -1;  // pipes
  bool busy_ = true;
  Clock::time_point since_ = Clock::now();
  std::string said_;  // the beginning of a line
  Repetitions repetitions_;
};

}  // namespace plumb
