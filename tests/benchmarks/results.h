#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/statistics.h"
#include "window_times.h"

namespace plumb::benchmarks {

/// Which times are compared: CPU time, which other processes hardly affect, if one thread does all the work, and wall
/// time if there are several.
enum class TimeBasis { cpu, wall };

/// Whether something else had the processor: wall and CPU time differ by more than a tenth of the wall time.
bool disturbed(const Elapsed&);

/// Statistics over rounds of that many steps.
struct TimesSummary {
  Quartiles wall, cpu;  // s a step
  Quartiles speed;      // time of the reference over this one's, in the same round: 2 means twice as fast
  int disturbed = 0;    // rounds
};

/// Zeros if there are no rounds; a speed of zeros if the reference has none. Throws std::invalid_argument if both have
/// some, but not the same number.
TimesSummary summarize(std::span<const Elapsed> rounds, std::span<const Elapsed> reference, int steps, TimeBasis);

struct EngineResult {
  std::string engine;
  EngineTimes times;
  TimesSummary summary;
};

/// The times of all engines on one scene.
struct BenchmarkResult {
  std::string scene;
  std::string about;
  StepWindow window;
  int threads = 1;
  int rounds = 0;
  TimeBasis basis = TimeBasis::cpu;
  std::string against;  // the engine that speeds are relative to
  std::vector<EngineResult> engines;
};

/// A table with a line for each engine.
std::string table(const BenchmarkResult&);

/// The format of Google Benchmark, whose tools compare such files: every round, and the median over rounds as an
/// aggregate; times in us a step. An engine without a result has `error_occurred` and `error_message`.
std::string google_json(const std::vector<BenchmarkResult>&);

}  // namespace plumb::benchmarks
