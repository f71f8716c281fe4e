#include "reports/writers/run_curves.h"

#include <limits>

namespace plumb {
namespace {

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

}  // namespace

std::vector<RunCurves> run_curves(const Report& report) {
  std::vector<RunCurves> all;
  for (const RunRecord& run : report.runs) {
    if (has_trace(run)) all.push_back(curves_of(run, reference_of(report, run)));
  }
  return all;
}

}  // namespace plumb
