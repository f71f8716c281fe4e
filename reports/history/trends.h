#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/history/change_points.h"
#include "reports/history/store.h"

/// What changed over the snapshots of a history, for the console and for the page.
namespace plumb {

/// A series and where it changes.
struct Trend {
  Series series;                     // finite values only
  std::string machine;               // that step times were measured on; "" for other metrics
  std::vector<ChangePoint> changes;  // `at` is an index in the series' values
};

/// One trend for each series with a finite value. Step times are noisy and get one for each machine, compiler and
/// flags; all other numbers are exact.
std::vector<Trend> trends_of(const std::vector<SnapshotHead>&, const std::vector<Series>&);

struct VerdictChange {
  Subject subject;
  std::size_t snapshot = 0;  // the first with the new verdict
  std::string before, after;
};

std::vector<VerdictChange> verdict_changes(const std::vector<VerdictSeries>&);

/// One line for each snapshot.
std::string text_of(const std::vector<SnapshotHead>&);

/// The changes in snapshots from `since` on (see utc; "": all), the newest snapshot first, and the largest change of
/// each snapshot first.
std::string text_of(const std::vector<SnapshotHead>&, const std::vector<Trend>&, const std::vector<VerdictChange>&,
                    const std::string& since = "");

/// Each trend with a chart of its values and its changes.
std::string text_of(const std::vector<SnapshotHead>&, const std::vector<Trend>&);

/// A study's document for the page. Its points are the snapshots. Its trends are those that change and all of step
/// times; the others are only counted.
nlohmann::ordered_json history_document(const History&);

}  // namespace plumb
