#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "reports/study/job.h"

/// The file in which a study keeps its results as they arrive: `study-NAME.jsonl`.
namespace plumb {

/// The first line of a results file: what its results belong to.
struct ResultsHead {
  std::string study;
  nlohmann::ordered_json configuration;
  std::string plan;  // plan_hash of the whole study
  Shard shard;
  std::size_t jobs = 0;  // in the shard
  std::map<std::string, std::string> environment;

  /// Describes the first difference that keeps the results of two files out of one study; "" if there is none. The
  /// machine and the shard may differ.
  std::string difference_from(const ResultsHead&) const;
};

/// A hash of texts and their order (FNV-1a, 64 bits, in hexadecimal).
std::string hash_of_lines(std::span<const std::string>);

/// The hash of all keys of a plan, in order.
std::string plan_hash(std::span<const Job>);

struct StoredResults {
  ResultsHead head;
  std::map<std::string, JobResult> results;  // by key
  std::size_t bytes = 0;  // up to the end of the last complete line; the rest was cut off by an interruption
};

/// The results of all jobs, in the plan's order. Throws std::out_of_range if one is missing.
std::vector<JobResult> in_plan_order(std::span<const Job>, const std::map<std::string, JobResult>& by_key);

/// Throws std::invalid_argument, naming the file and line, if the file cannot be read, is not a results file of this
/// format, or has two results for one key.
StoredResults read_results(const std::filesystem::path&);

/// Appends results, one line of JSON each. A line is written in one call, so an interruption can damage only the last
/// one. The file is locked: one process writes it at a time.
class ResultsFile {
 public:
  /// Starts a new file and replaces an existing one. Throws std::invalid_argument, with the system's reason, if it
  /// cannot be written or if another process still holds it after a second.
  static ResultsFile create(const std::filesystem::path&, const ResultsHead&);
  /// Appends to a file after the results that were read from it. Throws like `create`.
  static ResultsFile append(const std::filesystem::path&, const StoredResults&);

  ResultsFile(ResultsFile&&) noexcept;
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ResultsFile& operator=(ResultsFile&&) = delete;
  ~ResultsFile();

  /// Throws std::runtime_error if the file can no longer be written.
  void add(std::span<const JobResult>);

 private:
  ResultsFile(const std::filesystem::path&, std::size_t bytes_to_keep);
  void write(const std::string&);

  std::filesystem::path path_;
  int file_;
};

}  // namespace plumb
