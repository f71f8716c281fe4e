#pragma once

#include <string>

#include "reports/gate/baseline.h"

/// Baselines as files: sorted, a line for every number, so that a change shows as the lines it changes.
namespace plumb {

std::string to_text(const Baseline&);

/// Throws std::invalid_argument, naming the file and the place in it, for what cannot be read or is no baseline.
Baseline read_baseline(const std::string& path);

/// The same, of a baseline or of a report.json; the latter knows neither bits nor how far numbers may move, and asks
/// for exactly the cases that are in it.
Baseline read_results(const std::string& path);

}  // namespace plumb
