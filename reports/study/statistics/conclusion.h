#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "reports/study/job.h"
#include "reports/study/statistics/ensemble.h"

namespace plumb {

/// The probability that any of all intervals of a study misses its truth: each misses with this, divided by their
/// number (Bonferroni).
constexpr double statistics_miss = 0.01;

/// The ensemble's steps, runs, statistics with their bands and sources, and control.
nlohmann::ordered_json description_of(const Ensemble&);

/// From the results of all runs: a verdict for each statistic and engine, for the console, the page and as a table.
Findings conclude_statistics(const std::vector<const Ensemble*>&, const std::vector<JobResult>&);

}  // namespace plumb
