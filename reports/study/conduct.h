#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reports/study/study.h"
#include "reports/system/jobs.h"

/// Running a study: from the command line into a folder, or its summary in memory for a report.
namespace plumb {

/// Options that all studies have. No result depends on them.
struct StudyOptions {
  std::string out = "out";
  int parallel = default_jobs();
  bool resume = false;
  bool fresh = false;
  std::string shard;
  double seconds = 60;
  double mebibytes = 4096;
  double enough = 0;  // s after which no further job starts; follow-up jobs get a third of them. 0: never

  void attach_to(CLI::App&);
};

/// Runs the jobs that have no result yet, of one shard if the options say so, and writes the findings once the whole
/// study is complete. Returns the exit code. Throws std::invalid_argument for mistakes of the user, before any job
/// runs.
int conduct(const Study&, const nlohmann::ordered_json& configuration, const StudyOptions&);

/// Told of each finished job: its key, and how many of how many jobs are done.
using SummaryProgress = std::function<void(const std::string& key, std::size_t done, std::size_t of)>;

/// Runs the summary of a study that has these options and returns the document that `plumb study` would write, with the
/// command. No results file is kept. Throws std::logic_error if the options are not the study's own.
nlohmann::ordered_json summary_document(const Study&, const std::vector<std::string>& options, int parallel,
                                        const SummaryProgress&);

}  // namespace plumb
