#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/history/schema.h"
#include "reports/history/snapshot.h"

namespace plumb {

/// A snapshot without its runs.
struct SnapshotHead {
  std::string id, commit, at;
  std::map<std::string, std::string> environment;
  std::map<std::string, int> verdicts;  // the number of runs with each
};

/// The name of the series of step times, in us.
constexpr const char* step_time = "step_us";

/// The values of one metric of one subject over the snapshots that have it. Step times have quartiles.
struct Series {
  struct Value {
    std::size_t snapshot = 0;  // index in History::heads
    double value = 0;          // NaN if not finite
    double low = 0, high = 0;
  };

  Subject subject;
  std::string metric, unit;
  std::vector<Value> values;
};

/// The verdicts of one subject, in the same way.
struct VerdictSeries {
  struct Value {
    std::size_t snapshot = 0;
    std::string verdict;
  };

  Subject subject;
  std::vector<Value> values;
};

/// Snapshots in an SQLite file, sorted by time, then id. Each is written as a whole or not at all; several processes
/// may write at once. Throws like open_history and Database.
class History {
 public:
  /// Opens an existing file to read it.
  static History of(const std::filesystem::path& path) {
    return History(open_history(path, Database::Missing::refuse));
  }
  /// Opens a file to add to it; creates it if it is missing.
  static History to_add(const std::filesystem::path& path) {
    return History(open_history(path, Database::Missing::create));
  }

  /// Returns false if the history already had it.
  bool add(const Snapshot&);

  std::vector<SnapshotHead> heads() const;

  /// Throws std::invalid_argument if the snapshot read is not the one that was added.
  Snapshot snapshot(const std::string& id) const;

  /// Sorted by subject, then metric. Only those of one metric if it is given.
  std::vector<Series> series(const std::string& metric = "") const;
  std::vector<VerdictSeries> verdicts() const;

 private:
  explicit History(Database database) : database_(std::move(database)) {}
  /// Maps the number of a snapshot's row to its index in heads().
  std::function<std::size_t(std::int64_t)> index_of_row() const;

  Database database_;
};

}  // namespace plumb
