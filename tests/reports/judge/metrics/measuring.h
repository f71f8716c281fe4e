#pragma once

#include <optional>
#include <string>

#include "reports/judge/metric.h"
#include "scenarios/catalog.h"

namespace plumb {

/// One metric of the catalog, by name.
inline std::optional<double> measured(const std::string& name, const MetricContext& context) {
  return Catalog<Metric>::find(name)->measure(context);
}

}  // namespace plumb
