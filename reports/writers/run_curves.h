#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "reports/judge/overlap.h"
#include "reports/judge/states.h"
#include "reports/report.h"

/// The data of the page's charts: what is plotted of each run over time.
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

/// For each run energy, momenta, speed of the fastest body, distance from the closed form (or from the case's first
/// engine) and deepest overlap over time, at no more than `most` moments, six significant digits each.
nlohmann::ordered_json series_of(std::span<const RunCurves>, std::size_t most = 300);

/// By case, in the report's order: {"scenario", "variant", "series": packed `series_of` its runs}. The page unpacks
/// those of the cases that are opened.
nlohmann::ordered_json series_by_case(std::span<const RunCurves>);

}  // namespace plumb
