#include "reports/timing/clock.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace plumb {
Elapsed time_steps(Simulation& simulation, double dt, std::size_t steps, CpuClock clock) {
  const double before = simulation.seconds_stepped().value_or(0);
  simulation.announce(dt, steps);
  const Stopwatch wall;
  const double cpu = cpu_seconds(clock);
  for (std::size_t i = 0; i < steps; ++i) simulation.step(dt);
  const double cpu_spent = cpu_seconds(clock) - cpu;
  const double passed = wall.seconds();
  if (const std::optional<double> own = simulation.seconds_stepped())
    return {.wall = *own - before, .cpu = *own - before};
  return {.wall = passed, .cpu = cpu_spent};
}

double time_of_run(const FreshSimulation& build, double dt, std::size_t steps, double at_least) {
  double spent = 0;
  double runs = 0;
  do {
    spent += time_steps(*build(), dt, steps, CpuClock::none).wall;
    ++runs;
  } while (spent < at_least);
  return spent / runs;
}

InstructionCounter::InstructionCounter() {
  perf_event_attr wanted{};
  wanted.type = PERF_TYPE_HARDWARE;
  wanted.size = sizeof(wanted);
  wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
  wanted.exclude_kernel = 1;
  wanted.exclude_hv = 1;
  wanted.inherit = 1;
  // Several counters may share one of the processor's. `count` scales for the time in which this one did not run.
  wanted.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
  if (file_ >= 0) return;
  const int error = errno;
  if (error == EACCES || error == EPERM) {
    missing_ = "the system forbids it (kernel.perf_event_paranoid must be 2 or less)";
  } else if (error == ENOENT || error == EOPNOTSUPP || error == ENODEV) {
    missing_ = "the processor, or the virtual machine, has no counter";
  } else {
    missing_ = std::strerror(error);
  }
}

InstructionCounter::~InstructionCounter() {
  if (file_ >= 0) close(file_);
}

std::optional<double> InstructionCounter::count() const {
  std::array<std::uint64_t, 3> values{};  // the count, and for how long it was enabled and running
  if (file_ < 0 || read(file_, values.data(), sizeof(values)) != sizeof(values) || values[2] == 0) return std::nullopt;
  return static_cast<double>(values[0]) * static_cast<double>(values[1]) / static_cast<double>(values[2]);
}

}  // namespace plumb
