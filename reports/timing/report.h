#pragma once

#include <string>
#include <vector>

#include "reports/timing/machine.h"
#include "reports/timing/side_by_side.h"

namespace plumb {

/// What a comparison of times came to, ready to be written.
struct TimingReport {
  std::string program_before, program_now;  // paths
  TimingFacts facts_before, facts_now;      // at the beginning
  std::string load_after;                   // of the machine, at the end
  std::string uncounted;                    // why instructions were not compared; "" where they were
  TimingRule rule;
  std::vector<JudgedTime> cases;
};

/// One verdict line, then what is slower, faster and has no result, then what there is to know about the machine.
std::string timing_text(const TimingReport&);

/// In the shape of Google Benchmark's JSON: "before/CASE" and "now/CASE", each sitting and the median, so that
/// `compare.py filters FILE before now` compares them.
std::string timing_json(const TimingReport&);

}  // namespace plumb
