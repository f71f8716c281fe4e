#include "tests/timing/injected_delay.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <stdexcept>

namespace plumb::injected_delay_test {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Steps that take 20 us of CPU time.
class Busy : public Simulation {
 public:
  void step(double) override {
    for (const double until = cpu_seconds() + 20e-6; cpu_seconds() < until;) {
    }
  }
  void read(std::span<BodyState>) const override {}
};

double time_of(Simulation& simulation) {
  const double begin = cpu_seconds();
  for (int i = 0; i < 1200; ++i) simulation.step(1);
  return cpu_seconds() - begin;
}

TEST(InjectedDelay, IsNoneUnlessTheVariableHoldsANumber) {
  unsetenv(delay_variable);
  auto plain = std::make_unique<Busy>();
  const Simulation* const same = plain.get();
  EXPECT_EQ(with_injected_delay(std::move(plain)).get(), same);
  setenv(delay_variable, "no", 1);
  plain = std::make_unique<Busy>();
  const Simulation* const again = plain.get();
  EXPECT_EQ(with_injected_delay(std::move(plain)).get(), again);
  unsetenv(delay_variable);
}

TEST(InjectedDelay, MakesStepsTakeThatMuchLonger) {
  setenv(delay_variable, "50", 1);
  const auto delayed = with_injected_delay(std::make_unique<Busy>());
  unsetenv(delay_variable);
  // The steps cannot take less than 24 ms. The delay adds half of that, and the machine what it adds.
  EXPECT_GE(time_of(*delayed), 1.45 * 24e-3);
}

TEST(InjectedDelay, NeedsAnEngineOfThatName) { EXPECT_THROW(delay_engine("nonesuch"), std::invalid_argument); }

}  // namespace
}  // namespace plumb::injected_delay_test
