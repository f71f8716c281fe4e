#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/find/complaint.h"
#include "reports/study/job.h"

namespace plumb {

/// One engine in the scenes of a search. Energy and overlap are measured alike for all engines, in the scenes that all
/// of them ran to the end, whatever they state about themselves.
struct RulerSummary {
  std::string engine;
  int scenes = 0, not_supported = 0, failed = 0, wrong = 0;  // wrong: by any judge but the run itself
  int compared = 0;                                          // scenes that all engines ran to the end
  int closed = 0;                                            // of these, without energy from outside
  double rise_median = 0;                                    // of the scene's energy range
  double above_thousandth = 0, above_hundredth = 0;          // share of scenes whose energy rises by more of its range
  double overlap_median = 0, overlap_high = 0;               // m, the deepest of a scene: median, nine in ten below
};

/// By engine, then scene by scene, the same scenes for each.
std::vector<RulerSummary> measured_alike(const std::vector<std::pair<std::string, std::vector<Opinion>>>&);

nlohmann::ordered_json as_json(const RulerSummary&);

/// Head and rows, for a table.
std::vector<std::vector<std::string>> rows_of(const std::vector<RulerSummary>&);

/// The findings of a search, each told once, and the ruler by which all engines are measured alike; found/NAME.json for
/// each finding, find.md and find.xml (JUnit).
Findings conclude_search(const nlohmann::ordered_json& configuration, const std::vector<JobResult>&);

}  // namespace plumb
