#include "reports/system/clock.h"

#include <ctime>

namespace plumb {

double cpu_seconds(CpuClock clock) {
  if (clock == CpuClock::none) return 0;
  timespec now{};
  clock_gettime(clock == CpuClock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace plumb
