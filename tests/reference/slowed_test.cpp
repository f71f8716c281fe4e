#include "reference/slowed.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <ctime>

namespace plumb {
namespace {

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Steps that take 20 us of CPU time.
class Busy : public Simulation {
 public:
  void step(double) override {
    for (const double until = cpu_now() + 20e-6; cpu_now() < until;) {
    }
  }
  void read(std::span<BodyState>) const override {}
};

double time_of(Simulation& simulation) {
  const double begin = cpu_now();
  for (int i = 0; i < 1200; ++i) simulation.step(1);
  return cpu_now() - begin;
}

TEST(Slowed, IsNothingUnlessAskedFor) {
  unsetenv("PLUMB_SLOWDOWN");
  auto plain = std::make_unique<Busy>();
  const Simulation* const same = plain.get();
  EXPECT_EQ(slowed(std::move(plain)).get(), same);
  setenv("PLUMB_SLOWDOWN", "no", 1);
  plain = std::make_unique<Busy>();
  const Simulation* const again = plain.get();
  EXPECT_EQ(slowed(std::move(plain)).get(), again);
  unsetenv("PLUMB_SLOWDOWN");
}

TEST(Slowed, TakesThatMuchLonger) {
  setenv("PLUMB_SLOWDOWN", "50", 1);
  const auto half_as_fast_again = slowed(std::make_unique<Busy>());
  unsetenv("PLUMB_SLOWDOWN");
  // The steps cannot take less than 24 ms; half of that comes on top, and what the machine adds.
  EXPECT_GE(time_of(*half_as_fast_again), 1.45 * 24e-3);
}

}  // namespace
}  // namespace plumb
