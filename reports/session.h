#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "reports/jobs.h"
#include "reports/report.h"

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
  /// began it. Throws std::invalid_argument for what the user should put right, before anything is run.
  Report conduct(const std::string& command) const;
};

}  // namespace plumb
