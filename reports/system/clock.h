#pragma once

#include <chrono>

/// The only clocks of reports.
namespace plumb {

/// Wall time since it was constructed.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Which CPU time to measure. That of the process includes all of its threads: it counts work wherever it is done.
/// `none` saves the two system calls, about half a microsecond, that would otherwise be part of the wall time.
enum class CpuClock { none, thread, process };

/// The CPU time so far, s; 0 for CpuClock::none.
double cpu_seconds(CpuClock);

}  // namespace plumb
