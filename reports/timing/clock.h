#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "reference/simulation.h"
#include "reports/system/clock.h"

/// Measures what the steps of a simulation cost: wall time, CPU time and instructions.
namespace plumb {

/// Builds a simulation in its initial state. Every call returns the same one, so that repeated runs do the same work.
using FreshSimulation = std::function<std::unique_ptr<Simulation>()>;

struct Elapsed {
  double wall = 0;  // s
  double cpu = 0;   // s; 0 for CpuClock::none
};

/// The time of that many steps of dt seconds. Nothing but `step` is between the clock readings; of an engine that has a
/// clock of its own, what that says.
Elapsed time_steps(Simulation&, double dt, std::size_t steps, CpuClock);

/// The wall time of all steps of one run, in s: the mean over as many runs, each from its initial state, as take
/// `at_least` seconds together.
double time_of_run(const FreshSimulation&, double dt, std::size_t steps, double at_least = 0);

/// Counts the instructions that this process executes outside the kernel, including those of threads started later, if
/// the system and the processor allow it.
class InstructionCounter {
 public:
  InstructionCounter();
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;
  ~InstructionCounter();

  /// The count so far, or nullopt if instructions cannot be counted.
  std::optional<double> count() const;
  /// Why instructions cannot be counted; "" if they can.
  const std::string& missing() const { return missing_; }

 private:
  int file_ = -1;
  std::string missing_;
};

}  // namespace plumb
