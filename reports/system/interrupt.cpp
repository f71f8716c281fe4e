#include "reports/system/interrupt.h"

#include <csignal>

namespace plumb {
namespace {

volatile std::sig_atomic_t was_raised = 0;

void remember(int) { was_raised = 1; }

}  // namespace

Interrupt::Interrupt() : on_int_(std::signal(SIGINT, remember)), on_term_(std::signal(SIGTERM, remember)) {
  was_raised = 0;
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, on_int_);
  std::signal(SIGTERM, on_term_);
}

bool Interrupt::raised() { return was_raised != 0; }

}  // namespace plumb
