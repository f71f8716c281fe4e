#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/run/run.h"
#include "reports/system/jobs.h"
#include "reports/writers/output.h"

namespace CLI {
class App;
}

namespace plumb {

/// Prints what is rarely meant in the scene files among the cases, on standard error.
void warn_about_files(std::span<const Case>);

/// What `run` and `report` share: their options, running the experiment, writing the files and the table.
struct Session {
  std::vector<std::string> scenarios;
  bool all = false;
  bool converged = false;  // with a larger budget
  bool no_converged = false;
  bool no_timings = false;
  bool relations = false;
  int ensemble = 12;
  std::vector<std::string> engines;
  std::string dt = "1/60";
  std::string out = "out";
  int jobs = default_jobs();
  bool verbose = false, quiet = false, json = false;

  void attach_to(CLI::App&);

  /// Body-steps of a converged reference; 0: none.
  std::size_t refinement() const;

  /// Whether lines of text may go to standard output.
  bool prints_text() const { return !quiet && !json; }

  /// Runs the cases, writes the files, and prints the table and the files' paths, or what the options ask for instead.
  /// `command` is the name of the command;
  /// `complete` may add to the report before it is written. Throws std::invalid_argument for bad options, before
  /// anything runs.
  Report conduct(
      const std::string& command, const std::function<void(Report&)>& complete = [](Report&) {}) const;

 private:
  void print(const Report&, const OutputFolder::Written&) const;
};

}  // namespace plumb
