#include "reports/system/terminal.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "reports/system/layout.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

volatile std::sig_atomic_t interrupt_raised = 0;

void remember_interrupt(int) { interrupt_raised = 1; }

}  // namespace

std::size_t terminal_width(std::size_t otherwise) {
  constexpr std::size_t least = 60;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return otherwise;
  return std::max<std::size_t>(size.ws_col, least);
}

ProgressLine::ProgressLine(Kind kind)
    : terminal_(isatty(STDERR_FILENO) != 0),
      quiet_(kind == Kind::quiet),
      pace_(kind == Kind::long_run ? 0 : LogPace::interval) {}

ProgressLine::~ProgressLine() {
  clear();
  if (logged_) fmt::print(stderr, "done in {:.0f} s\n", since_start_.seconds());
}

void ProgressLine::show(const std::string& text) const {
  if (quiet_) return;
  if (terminal_) {
    clear();
    fmt::print(stderr, "{}", cut(printable(text, text.npos), 95));
  } else if (pace_.due(since_start_.seconds())) {
    fmt::print(stderr, "{}\n", printable(text, text.npos));
    logged_ = true;
  }
  std::fflush(stderr);
}

void ProgressLine::clear() const {
  if (terminal_ && !quiet_) std::fputs("\r\033[K", stderr);
}

Interrupt::Interrupt()
    : on_int_(std::signal(SIGINT, remember_interrupt)), on_term_(std::signal(SIGTERM, remember_interrupt)) {
  interrupt_raised = 0;
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, on_int_);
  std::signal(SIGTERM, on_term_);
}

bool Interrupt::raised() { return interrupt_raised != 0; }

}  // namespace plumb
