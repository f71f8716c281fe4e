#include "reports/system/progress_line.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace plumb {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const std::string& what) const {
  if (!terminal_) return;
  clear();
  fmt::print(stderr, "{:.95}", what);
  std::fflush(stderr);
}

void ProgressLine::clear() const {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

}  // namespace plumb
