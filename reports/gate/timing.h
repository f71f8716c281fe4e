#pragma once

#include <string>
#include <vector>

#include "reports/gate/result.h"
#include "reports/run/run.h"
#include "reports/timing/report.h"

namespace CLI {
class App;
}

/// The part of the gate that judges times: whether another build of Plumb steps the same scenes faster.
namespace plumb {

struct TimingOptions {
  std::string against;  // the other program; "": times are not judged
  std::string engine = "impulse";
  std::string file;  // for timing_json; "": none

  void attach_to(CLI::App&);
};

/// Times the cases in the other program and in this one, and judges them. Throws std::invalid_argument, naming the
/// option, if the other program cannot be run, is no timing worker or runs on another machine, or if the file cannot be
/// written, in each case before anything is timed.
TimingReport time_against(const TimingOptions&, const std::vector<Case>&, double dt);

/// Adds the times of `engine` to the gate's result: a run "time CASE" for each case, a regression for each case that
/// takes longer than before, and a note for each without a result.
void add_times(GateResult&, const TimingReport&, const std::string& engine);

}  // namespace plumb
