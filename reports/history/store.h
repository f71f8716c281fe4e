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

/// A snapshot without its answers.
struct SnapshotHead {
  std::string id, commit, at;
  std::map<std::string, std::string> environment;
  std::map<std::string, int> verdicts;  // how many of each
};

/// The metric that step times are a series of; in us.
constexpr const char* step_time = "step_us";

/// What one subject's answers say in one metric, over the snapshots that have it; of step times with
/// quartiles.
struct Series {
  struct Value {
    std::size_t snapshot = 0;  // its place in History::heads
    double value = 0;          // NaN: not finite
    double low = 0, high = 0;
  };

  Subject subject;
  std::string metric, unit;
  std::vector<Value> values;
};

/// A subject's verdicts, in the same way.
struct VerdictSeries {
  struct Value {
    std::size_t snapshot = 0;
    std::string verdict;
  };

  Subject subject;
  std::vector<Value> values;
};

/// Snapshots in an SQLite file, each written whole or not at all; several processes may write at once. For what goes
/// wrong see open_history and Database. Snapshots are in order of their moments, then of their ids.
class History {
 public:
  /// To read one that is there.
  static History of(const std::filesystem::path& path) {
    return History(open_history(path, Database::Missing::refuse));
  }
  /// To add to it; it is made where it is missing.
  static History to_add(const std::filesystem::path& path) {
    return History(open_history(path, Database::Missing::make));
  }

  /// False where it was there before.
  bool add(const Snapshot&);

  std::vector<SnapshotHead> heads() const;

  /// Throws std::invalid_argument where what is kept is not what was added.
  Snapshot snapshot(const std::string& id) const;

  /// In order of their subjects, then metrics; at most those of one metric, where it is given.
  std::vector<Series> series(const std::string& metric = "") const;
  std::vector<VerdictSeries> verdicts() const;

 private:
  explicit History(Database database) : database_(std::move(database)) {}
  std::function<std::size_t(std::int64_t)> places() const;  // by the number of a snapshot
  std::map<std::string, std::string> texts_of(const std::string& json) const;
  std::string damaged() const;

  Database database_;
};

}  // namespace plumb
