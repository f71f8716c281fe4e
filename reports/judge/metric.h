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
  const Trace* truth = nullptr;  // the closed form's run, where there is one
  double truth_until = 0;        // s, for how long it holds
};

enum class Better { lower, higher, neither };

/// One number from a trace. Nothing where it makes no sense for that scene.
struct Metric {
  std::string name;
  std::string unit;
  std::string definition;
  Better better = Better::lower;
  std::function<std::optional<double>(const MetricContext&)> measure;
};

/// By name, every metric that makes sense for the scene.
std::map<std::string, Measured> measure(const MetricContext&);

}  // namespace plumb
