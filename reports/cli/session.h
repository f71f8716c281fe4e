#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/system/jobs.h"

namespace plumb {

/// What `run` and `report` have in common: their options, and the way from there to files and a table.
struct Session {
  std::vector<std::string> scenarios;
  bool all = false;
  bool converged = false;
  int ensemble = 16;
  std::vector<std::string> engines;
  std::string dt = "1/60";
  std::string out = "out";
  int jobs = default_jobs();

  void attach_to(CLI::App&);

  /// Runs what is asked for, writes the files and prints the table and where the files are. `command` is the word that
  /// began it; `complete` may add to the report before it is written. Throws std::invalid_argument for what the user
  /// should put right, before anything is run.
  Report conduct(
      const std::string& command, const std::function<void(Report&)>& complete = [](Report&) {}) const;
};

}  // namespace plumb
