#include "reports/timing/clock.h"

#include <gtest/gtest.h>

#include <ctime>

namespace plumb::clock_test {
namespace {

// Burns 20 us of CPU time in each step.
class BusySimulation : public Simulation {
 public:
  explicit BusySimulation(int& steps) : steps_(steps) {}
  void step(double) override {
    ++steps_;
    const std::clock_t until = std::clock() + 20 * CLOCKS_PER_SEC / 1000000;
    while (std::clock() < until) {
    }
  }
  void read(std::span<BodyState>) const override {}

 private:
  int& steps_;
};

TEST(Clock, MeasuresWallAndCpuTimeOfSteps) {
  int steps = 0;
  BusySimulation busy(steps);
  for (const CpuClock clock : {CpuClock::process, CpuClock::thread}) {
    const Elapsed elapsed = time_steps(busy, 1, 50, clock);
    EXPECT_GE(elapsed.cpu, 0.9e-3);
    EXPECT_GE(elapsed.wall, 0.9e-3);
  }
  EXPECT_EQ(steps, 100);
  EXPECT_EQ(time_steps(busy, 1, 1, CpuClock::none).cpu, 0);
}

TEST(Clock, TimesARunFromAFreshStartAsOftenAsNeeded) {
  int built = 0;
  int steps = 0;
  const FreshSimulation build = [&] {
    ++built;
    return std::make_unique<BusySimulation>(steps);
  };
  EXPECT_GT(time_of_run(build, 1, 5), 90e-6);
  EXPECT_EQ(built, 1);
  EXPECT_EQ(steps, 5);
  const double mean = time_of_run(build, 1, 5, 0.02);
  EXPECT_GT(mean, 90e-6);
  EXPECT_EQ(steps, 5 * built);
  EXPECT_GE(mean * (built - 1), 0.02 * (1 - 1e-12));
}

TEST(InstructionCounter, CountsOrSaysWhyNot) {
  const InstructionCounter counter;
  const auto before = counter.count();
  EXPECT_EQ(before.has_value(), counter.missing().empty()) << counter.missing();
  volatile unsigned sum = 0;
  for (unsigned i = 0; i < 100000; ++i) sum = sum + i;
  if (!before) return;
  EXPECT_GE(*counter.count(), *before + 100000);
}

}  // namespace
}  // namespace plumb::clock_test
