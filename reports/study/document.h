#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/study/results_file.h"
#include "reports/study/study.h"
#include "reports/writers/output.h"

/// What a study writes: from its own results, or from those of its shards.
namespace plumb {

/// A whole study as JSON: its results in the plan's order, and its findings. Everything that depends on the clock is
/// under "timings"; the rest is the same in every run, however the study was divided.
nlohmann::ordered_json document_of(const Study&, const ResultsHead&, const std::vector<JobResult>&, const Findings&);

/// One line per result. Values and times that are numbers, strings or booleans become columns.
std::string csv_of(const std::vector<JobResult>&);

/// Concludes the study, writes study-NAME.json, .csv and .html into the folder, and prints the findings and the paths.
/// Takes the results of all jobs, in the plan's order. Returns the exit code: 1 if the findings have failed.
int write_study(const Study&, const ResultsHead&, const StudyPlan&, const std::vector<JobResult>&, const OutputFolder&);

/// Merges the results files of all shards of a study and writes what the undivided study would have written, apart from
/// its timings; returns its exit code. Throws std::invalid_argument listing every problem by file: a shard that is
/// given twice, missing or incomplete, one of another study, configuration or version, and results of jobs outside of a
/// file's shard.
int merge_shards(const std::vector<std::filesystem::path>& files, const OutputFolder&);

}  // namespace plumb
