#pragma once

#include <chrono>
#include <ctime>

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
inline double cpu_seconds(CpuClock clock) {
  if (clock == CpuClock::none) return 0;
  timespec now{};
  clock_gettime(clock == CpuClock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace plumb
