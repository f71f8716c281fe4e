#include "reports/writers/run_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/judge/mechanics.h"
#include "reports/writers/packed.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

bool has_trace(const RunRecord& run) { return run.scene && run.trace && run.trace->size() > 0; }

// The run that poses are compared with: the closed form of the case, or its first engine, as in the comparator.
const RunRecord* reference_of(const Report& report, const RunRecord& run) {
  const RunRecord* reference = nullptr;
  for (const RunRecord& other : report.runs) {
    if (other.scenario != run.scenario || other.variant != run.variant || other.status != Status::ok) continue;
    if (other.exact) return &other;
    if (reference == nullptr) reference = &other;
  }
  return reference;
}

RunCurves curves_of(const RunRecord& run, const RunRecord* reference) {
  RunCurves curves{.run = &run};
  if (reference != nullptr && has_trace(*reference)) {
    curves.difference =
        pose_differences(*run.scene, *run.trace, *reference->trace, std::numeric_limits<double>::infinity());
  }
  const Overlap overlap(*run.scene);
  for (std::size_t i = 0; i < run.trace->size(); ++i) curves.deepest.push_back(overlap.deepest(run.trace->states(i)));
  return curves;
}

// Six significant digits: more than a chart can show, in a third of the bytes.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, 5 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  return std::isfinite(unit) && unit > 0 ? std::round(value * unit) / unit : value;
}

Json series_of(const RunCurves& curves, std::size_t most) {
  const RunRecord& run = *curves.run;
  const Trace& trace = *run.trace;
  const Conserved conserved(*run.scene);
  Json series{{"scenario", run.scenario}, {"variant", run.variant}, {"engine", run.engine}, {"method", run.method}};
  for (const char* column :
       {"t", "energy", "momentum_x", "momentum_y", "angular_momentum", "fastest", "pose_difference", "overlap"}) {
    series[column] = Json::array();
  }
  const std::size_t last = trace.size() - 1;
  const std::size_t shown = std::min(trace.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t moment = shown == 1 ? last : i * last / (shown - 1);
    const auto states = trace.states(moment);
    const Momentum momentum = conserved.momentum(states);
    series["t"].push_back(rounded(trace.time(moment)));
    series["energy"].push_back(rounded(conserved.energy(states).total()));
    series["momentum_x"].push_back(rounded(momentum.linear.x));
    series["momentum_y"].push_back(rounded(momentum.linear.y));
    series["angular_momentum"].push_back(rounded(momentum.angular));
    series["fastest"].push_back(rounded(fastest_speed(*run.scene, states)));
    series["pose_difference"].push_back(
        moment < curves.difference.size() ? Json(rounded(curves.difference[moment].position)) : Json());
    series["overlap"].push_back(rounded(curves.deepest[moment].depth));
  }
  return series;
}

}  // namespace

std::vector<RunCurves> run_curves(const Report& report) {
  std::vector<RunCurves> all;
  for (const RunRecord& run : report.runs) {
    if (has_trace(run)) all.push_back(curves_of(run, reference_of(report, run)));
  }
  return all;
}

Json series_of(std::span<const RunCurves> runs, std::size_t most) {
  Json all = Json::array();
  for (const RunCurves& curves : runs) all.push_back(series_of(curves, most));
  return all;
}

Json series_by_case(std::span<const RunCurves> runs) {
  struct Case {
    std::string scenario, variant;
    Json series = Json::array();
  };
  std::vector<Case> cases;
  for (Json& one : series_of(runs)) {
    const auto same = [&](const Case& item) {
      return one["scenario"] == item.scenario && one["variant"] == item.variant;
    };
    auto found = std::find_if(cases.begin(), cases.end(), same);
    if (found == cases.end()) found = cases.insert(cases.end(), Case{one["scenario"], one["variant"]});
    found->series.push_back(std::move(one));
  }
  Json all = Json::array();
  for (const Case& item : cases) {
    all.push_back({{"scenario", item.scenario}, {"variant", item.variant}, {"series", packed(item.series.dump())}});
  }
  return all;
}

}  // namespace plumb
