#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/report.h"

/// What a history keeps of a report.
namespace plumb {

/// What a series of values is about: one engine running one case.
struct Subject {
  std::string scenario, variant;
  std::string engine;  // see label_of
  double dt = 0;       // s

  auto operator<=>(const Subject&) const = default;
};

struct StepTime {
  double median = 0, low = 0, high = 0;  // us, with quartiles
  int repetitions = 0;
};

/// The metric that is added to those of a report: the largest error / tolerance of the checks of a run.
constexpr const char* worst_ratio_metric = "worst_error_ratio";

struct SnapshotRun {
  std::string verdict;
  std::map<std::string, Measured> metrics;  // NaN if not finite
  std::optional<StepTime> time;
};

struct Snapshot {
  std::string commit;
  std::string at;  // see utc
  std::vector<std::string> command;
  std::map<std::string, std::string> environment;
  std::map<Subject, SnapshotRun> runs;
};

/// One line of JSON without a line break. Equal snapshots give equal lines; numbers keep every bit.
std::string to_line(const Snapshot&);

/// The same line with its hash at the end, so that a changed digit is noticed when it is read.
std::string to_sealed_line(const Snapshot&);

/// Reads a line of this version or an older one, with or without its hash. Throws std::invalid_argument, naming `name`
/// and the place, if it is not such a line or was changed.
Snapshot snapshot_of_line(const std::string& line, const std::string& name);

/// The hash of the snapshot's line: equal for equal snapshots only.
std::string id_of(const Snapshot&);

/// The id that versions 1 and 2 of the database gave it.
std::string old_id_of(const Snapshot&);

/// Takes a snapshot of the text of a report.json, see report.schema.json. Commit and time are left empty. Throws
/// std::invalid_argument, naming `name` and the place, if it cannot be read.
Snapshot snapshot_of_report(const std::string& text, const std::string& name);

}  // namespace plumb
