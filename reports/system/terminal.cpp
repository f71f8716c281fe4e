#include "reports/system/terminal.h"

#include <fmt/core.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace plumb {
namespace {

volatile std::sig_atomic_t interrupt_raised = 0;

void remember_interrupt(int) { interrupt_raised = 1; }

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const std::string& text) const {
  if (!terminal_) return;
  clear();
  fmt::print(stderr, "{:.95}", text);
  std::fflush(stderr);
}

void ProgressLine::clear() const {
  if (terminal_) std::fputs("\r\033[K", stderr);
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
