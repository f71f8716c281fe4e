#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "reports/study/results_file.h"
#include "reports/writers/output.h"

/// Dividing a study among machines, and merging the results.
namespace plumb {

/// Returns the value of an environment variable, or null.
using EnvironmentLookup = std::function<const char*(const char* name)>;

/// The shard that belongs to this task of a Slurm array; nullopt outside of one. Throws std::invalid_argument for an
/// array with gaps: its tasks do not know their index.
std::optional<Shard> slurm_shard(const EnvironmentLookup&);

/// The units of jobs that belong to a shard: every n-th, so that expensive and cheap ones are spread.
std::vector<std::span<const Job>> units_in(const Shard&, const std::vector<std::span<const Job>>& units);

/// Merges the results files of all shards of a study and writes what the undivided study would have written, apart from
/// its timings. Throws std::invalid_argument listing every problem by file: a shard that is given twice, missing or
/// incomplete, one of another study, configuration or version, and results of jobs outside of a file's shard.
void merge_shards(const std::vector<std::filesystem::path>& files, const OutputFolder&);

}  // namespace plumb
