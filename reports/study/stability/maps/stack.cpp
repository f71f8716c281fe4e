#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"

namespace plumb::maps::stack {
namespace {

std::vector<Trial> trials(double boxes, double, const EngineConfig& config) {
  Trial trial{.scene = std::make_shared<const Scene>(scene_of("stacking", {{"boxes", boxes}})), .dt = usual_dt};
  trial.watches = status(trial.scene, 1, stated_gap(config, usual_dt));
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "stack",
     .question = "How many boxes can stand on each other for ten seconds, and what does more work give?",
     .x = {.name = "boxes", .from = 1, .to = 100, .logarithmic = true, .whole = true},
     .trials = trials,
     .boundaries = {{.name = "stands"}}}};

}  // namespace
}  // namespace plumb::maps::stack
