#pragma once

#include <optional>
#include <string>

#include "reports/metric.h"
#include "scenarios/catalog.h"

namespace plumb {

/// One metric of the catalog, by name.
inline std::optional<double> measured(const std::string& name, const Evidence& evidence) {
  return Catalog<Metric>::find(name)->measure(evidence);
}

}  // namespace plumb
