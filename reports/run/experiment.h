#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/run/run.h"

namespace plumb {

struct Plan {
  std::vector<Case> cases;
  std::vector<EngineConfig> configs;
  double dt = 1.0 / 60;  // s
  int jobs = 1;          // cases run at once; their results do not depend on it
  bool refine = false;   // a converged reference where there is no closed form
  bool timed = true;     // what a step costs, measured when all else is done
  int ensemble = 0;  // runs of each engine that are compared beyond a scene's horizon; 0: horizons are not looked for
};

/// Told before each run what comes next: "bounce e=0.5: box2d", the how-manieth of how many. Never two at a time.
using Progress = std::function<void(const std::string& what, std::size_t done, std::size_t of)>;

/// Runs every case with its closed form and all configs, measures, judges and compares; then, with nothing else
/// running, times those that ran.
/// `title`, `command` and `environment` are left to the caller.
Report carry_out(const Plan&, const Progress&);

}  // namespace plumb
