#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "reports/report.h"
#include "reports/trace.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// What a metric may look at.
struct MetricContext {
  const Scene& scene;
  const Trace& trace;
  const Trace* truth = nullptr;  // of the closed form, if there is one
  double truth_until = 0;        // s, for how long it is valid
};

enum class Better { lower, higher, neither };

/// "lower", "higher", "neither".
const char* name_of(Better);

/// One number from a trace; nullopt if it does not apply to the scene.
struct Metric {
  std::string name;
  std::string unit;
  std::string definition;
  Better better = Better::lower;
  std::function<std::optional<double>(const MetricContext&)> measure;
};

/// By name, every metric that applies to the scene.
std::map<std::string, Measured> measure(const MetricContext&);

}  // namespace plumb
