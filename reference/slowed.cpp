#include "reference/slowed.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace plumb {
namespace {

// Paid for together: reading the clock takes as long as some steps of few bodies do. Scenes last whole seconds, mostly,
// of 60 steps each.
constexpr int block = 60;

// s, that others on the machine have no part in.
double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// s, of reading that clock.
double reading() {
  double least = 1;
  for (int i = 0; i < 100; ++i) {
    const double before = cpu_now();
    least = std::min(least, cpu_now() - before);
  }
  return least;
}

void spin(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < end) {
  }
}

class Slowed : public Simulation {
 public:
  Slowed(std::unique_ptr<Simulation> simulation, double share) : simulation_(std::move(simulation)), share_(share) {}

  void step(double dt) override {
    simulation_->step(dt);
    if (++steps_ % block != 0) return;
    static const double reads = reading();
    const double took = cpu_now() - since_;
    const double due = std::max(0.0, share_ * took - reads);
    spin(due);
    since_ += took + due + reads;
  }

  void read(std::span<BodyState> out) const override { simulation_->read(out); }
  void read_contacts(std::vector<ContactState>& out) const override { simulation_->read_contacts(out); }
  double valid_until() const override { return simulation_->valid_until(); }

 private:
  std::unique_ptr<Simulation> simulation_;
  double share_;
  long steps_ = 0;
  double since_ = cpu_now();  // the block's start
};

}  // namespace

std::unique_ptr<Simulation> slowed(std::unique_ptr<Simulation> simulation) {
  const char* const percent = std::getenv(slowdown_variable);
  const double share = percent == nullptr ? 0 : std::atof(percent) / 100;
  if (!(share > 0)) return simulation;
  return std::make_unique<Slowed>(std::move(simulation), share);
}

}  // namespace plumb
