#include "tests/timing/injected_delay.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace plumb {
namespace {

// Steps that share one delay: reading the clock takes as long as a step of a few bodies. Most scenes last a whole
// number of seconds, at 60 steps each.
constexpr int steps_per_delay = 60;

// s, CPU time of this process: other processes on the machine do not count.
double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// s, the cost of one cpu_now().
double clock_cost() {
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

class Delayed : public Simulation {
 public:
  Delayed(std::unique_ptr<Simulation> simulation, double fraction)
      : simulation_(std::move(simulation)), fraction_(fraction) {}

  void step(double dt) override {
    simulation_->step(dt);
    if (++steps_ % steps_per_delay != 0) return;
    static const double clock = clock_cost();
    const double took = cpu_now() - since_;
    const double delay = std::max(0.0, fraction_ * took - clock);
    spin(delay);
    since_ += took + delay + clock;
  }

  void read(std::span<BodyState> out) const override { simulation_->read(out); }
  void read_contacts(std::vector<ContactState>& out) const override { simulation_->read_contacts(out); }
  double valid_until() const override { return simulation_->valid_until(); }

 private:
  std::unique_ptr<Simulation> simulation_;
  double fraction_;
  long steps_ = 0;
  double since_ = cpu_now();  // s, end of the last delay
};

}  // namespace

std::unique_ptr<Simulation> with_injected_delay(std::unique_ptr<Simulation> simulation) {
  const char* const percent = std::getenv(delay_variable);
  const double fraction = percent == nullptr ? 0 : std::atof(percent) / 100;
  if (!(fraction > 0)) return simulation;
  return std::make_unique<Delayed>(std::move(simulation), fraction);
}

void delay_engine(const std::string& name) {
  // The catalog gives const access only, but its entries are not const objects.
  auto* const engine = const_cast<Engine*>(Catalog<Engine>::find(name));
  if (engine == nullptr) throw std::invalid_argument("no engine \"" + name + "\"");
  engine->build = [build = engine->build](const Scene& scene, const Settings& settings) {
    return with_injected_delay(build(scene, settings));
  };
}

}  // namespace plumb
