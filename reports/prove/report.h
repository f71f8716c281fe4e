#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/prove/prove.h"
#include "reports/prove/sensitivity.h"

namespace plumb {

/// Everything that `plumb prove` found.
struct ProveReport {
  std::vector<FaultResult> faults;
  std::vector<CleanRun> clean;
  std::size_t cases = 0;

  std::size_t caught() const;
  std::size_t caught_by_physics() const;
  std::size_t runs_with_false_alarms() const;
  std::size_t loose_truths() const;
  /// Whether every fault was caught, there is no false alarm, and our engine could fail each truth.
  bool passed() const;
};

/// A summary line, a table of faults with the best detection of each, the fewest scenarios, of each check that raised a
/// false alarm the worst one, and the truths that our engine cannot fail.
std::string text_of(const ProveReport&);

nlohmann::ordered_json to_json(const ProveReport&);

/// Parts of both that the report on controls shares: "2.5 x allowed"; a detection; a number, null if it is infinite.
std::string ratio_text(double ratio);
nlohmann::ordered_json to_json(const Detection&);
nlohmann::ordered_json number_or_null(double);

/// Everything that `plumb prove --sensitivity` found.
struct SensitivityReport {
  std::vector<EngineStatement> statements;
  Sensitivities found;
  std::size_t cases = 0;
  double dt = 0;  // s

  /// Whether every statement's goal is reached in every parameter.
  bool passed() const;
};

/// A line for each parameter and statement: the smallest error seen, and the case and check that sees it.
std::string text_of(const SensitivityReport&);

/// A table with a row for each parameter, for a README.
std::string markdown_of(const SensitivityReport&);

nlohmann::ordered_json to_json(const SensitivityReport&);

}  // namespace plumb
