#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "reports/study/point.h"
#include "reports/study/shard.h"

namespace plumb {

/// The first line of a results file: what its points belong to.
struct ResultsHead {
  std::string study;
  nlohmann::ordered_json configuration;
  std::string plan;  // a hash of all keys of the whole study
  Shard shard;
  std::size_t points = 0;  // of the shard
  std::map<std::string, std::string> environment;

  /// What differs, in words, between files whose points may not stand in one study; "" where nothing does. Where they
  /// ran may differ, and the shard.
  std::string foreign_to(const ResultsHead&) const;
};

/// Of the keys, in order.
std::string plan_hash(std::span<const Point>);

struct KeptResults {
  ResultsHead head;
  std::map<std::string, PointResult> results;  // by key
  std::size_t whole = 0;  // bytes up to the end of the last whole line; what is beyond was torn by an interruption
};

/// Throws std::invalid_argument, naming the file, for what cannot be read, is no results file, or has a point twice.
KeptResults read_results(const std::filesystem::path&);

/// Points as they are found out, one line each (JSON), written whole and at once: an interruption tears the last line
/// at most. One process writes it at a time.
class ResultsFile {
 public:
  /// A new one in place of whatever is there. Throws std::invalid_argument, with the system's reason, where it cannot
  /// be written, or another process is writing it, and still does a second later.
  static ResultsFile begin(const std::filesystem::path&, const ResultsHead&);
  /// Goes on after what is kept there.
  static ResultsFile go_on(const std::filesystem::path&, const KeptResults&);

  ResultsFile(ResultsFile&&) noexcept;
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ResultsFile& operator=(ResultsFile&&) = delete;
  ~ResultsFile();

  /// Throws std::runtime_error where it cannot be written any more.
  void add(std::span<const PointResult>);

 private:
  ResultsFile(const std::filesystem::path&, std::size_t keep);
  void write(const std::string&);

  std::filesystem::path path_;
  int file_;
};

}  // namespace plumb
