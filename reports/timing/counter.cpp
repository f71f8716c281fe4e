#include "reports/timing/counter.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace plumb {

InstructionCounter::InstructionCounter() {
  perf_event_attr wanted{};
  wanted.type = PERF_TYPE_HARDWARE;
  wanted.size = sizeof(wanted);
  wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
  wanted.exclude_kernel = 1;
  wanted.exclude_hv = 1;
  wanted.inherit = 1;
  // Several counters may share one of the processor's; what was missed is then made up for in proportion.
  wanted.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
  if (file_ >= 0) return;
  const int error = errno;
  if (error == EACCES || error == EPERM) {
    missing_ = "the system forbids it (kernel.perf_event_paranoid must be 2 or less)";
  } else if (error == ENOENT || error == EOPNOTSUPP || error == ENODEV) {
    missing_ = "the processor, or what virtualises it, has no counter";
  } else {
    missing_ = std::strerror(error);
  }
}

InstructionCounter::~InstructionCounter() {
  if (file_ >= 0) close(file_);
}

std::optional<double> InstructionCounter::count() const {
  std::array<std::uint64_t, 3> said{};  // the count, and for how long it was wanted and had
  if (file_ < 0 || read(file_, said.data(), sizeof(said)) != sizeof(said) || said[2] == 0) return std::nullopt;
  return static_cast<double>(said[0]) * static_cast<double>(said[1]) / static_cast<double>(said[2]);
}

}  // namespace plumb
