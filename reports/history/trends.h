#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/history/change_points.h"
#include "reports/history/store.h"

namespace plumb {

/// A series and where it changes.
struct Trend {
  Series series;                     // finite values only
  std::string machine;               // that times were taken on; "" of what hangs on no clock
  std::vector<ChangePoint> changes;  // `at`: a place in the series' values
};

/// Of each series with a finite value. Times of different machines, compilers or flags are no one series.
std::vector<Trend> trends_of(const std::vector<SnapshotHead>&, const std::vector<Series>&);

struct VerdictChange {
  Subject subject;
  std::size_t snapshot = 0;  // the first after it
  std::string before, after;
};

std::vector<VerdictChange> verdict_changes(const std::vector<VerdictSeries>&);

/// What the page shows, in the shape of a study's document: its points are the snapshots; trends that change, or are of
/// times, and how many others there are.
nlohmann::ordered_json history_document(const History&);

}  // namespace plumb
