#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/prove/sensitivity.h"

namespace plumb {

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
