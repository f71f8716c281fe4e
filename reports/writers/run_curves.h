#pragma once

#include <span>
#include <vector>

#include "reports/judge/overlap.h"
#include "reports/judge/states.h"
#include "reports/report.h"

namespace plumb {

/// What the page plots of a run besides its states, one entry per recorded moment.
struct RunCurves {
  const RunRecord* run = nullptr;  // has a scene and a trace of at least one moment
  /// Distance from the case's closed form, or from its first engine if there is none. May end before the trace.
  std::vector<PoseDifference> difference;
  std::vector<BodyOverlap> deepest;  // deepest overlap, from the scene's geometry
};

/// One entry for every run with a trace. The report must outlive them.
std::vector<RunCurves> run_curves(const Report&);

}  // namespace plumb
