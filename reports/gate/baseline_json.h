#pragma once

#include <string>

#include "reports/gate/baseline.h"

/// Baselines as JSON files: sorted, with one line for each number, so that a diff shows the numbers that changed.
namespace plumb {

std::string to_text(const Baseline&);

/// Reads a baseline of this version or an older one. Throws std::invalid_argument, naming the file and the place in it,
/// if it cannot be read.
Baseline read_baseline(const std::string& path);

/// Reads a baseline or a report.json. A report has neither bits nor bounds, and its scenarios are exactly its cases.
/// Throws like read_baseline.
Baseline read_results(const std::string& path);

}  // namespace plumb
