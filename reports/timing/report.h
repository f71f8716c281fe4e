#pragma once

#include <string>
#include <vector>

#include "reports/system/environment.h"
#include "reports/timing/paired.h"

namespace plumb {

/// The result of timing two programs side by side.
struct TimingReport {
  std::string program_before, program_now;  // paths
  TimingFacts facts_before, facts_now;      // at the beginning
  std::string load_after;                   // of the machine, at the end
  std::string uncounted;                    // why instructions were not compared; "" if they were
  TimingRule rule;
  std::vector<JudgedTime> cases;
};

/// The verdict in one line; then the cases that are slower, faster or without a result; then the facts of the machine.
std::string timing_text(const TimingReport&);

/// The format of Google Benchmark: "before/CASE" and "now/CASE", each round and the median, so that
/// `compare.py filters FILE before now` compares them.
std::string timing_json(const TimingReport&);

}  // namespace plumb
