#pragma once

#include <cstddef>
#include <string>

#include "reports/system/clock.h"

/// Talking to the user while a program runs.
namespace plumb {

/// The columns of the terminal that is standard output, at least 60; `otherwise` if it is none.
std::size_t terminal_width(std::size_t otherwise);

/// When to write the next line to a log, so that the log of a long run stays short.
class LogPace {
 public:
  /// The first line comes after `first` seconds.
  explicit LogPace(double first) : next_(first) {}

  /// Whether a line is due at this time, s; then the next one is due `interval` later.
  bool due(double now) {
    if (now < next_) return false;
    next_ = now + interval;
    return true;
  }

  static constexpr double interval = 30;  // s

 private:
  double next_;
};

/// Progress on standard error. On a terminal, one line that is overwritten again and again and removed at the end.
/// Otherwise lines of a log: at most one in 30 s, and one at the end if there was any.
class ProgressLine {
 public:
  /// long_run: takes minutes, so a log has a line at the start. quiet: shows nothing.
  enum class Kind { usual, long_run, quiet };
  explicit ProgressLine(Kind = Kind::usual);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// Not from several threads at once.
  void show(const std::string& text) const;

 private:
  void clear() const;
  bool terminal_, quiet_;
  Stopwatch since_start_;
  mutable LogPace pace_;
  mutable bool logged_ = false;
};

/// While an object of this class exists, Ctrl-C and a scheduler's SIGTERM set a flag instead of ending the program.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  static bool raised();

 private:
  using Handler = void (*)(int);
  Handler on_int_, on_term_;
};

}  // namespace plumb
