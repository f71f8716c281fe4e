#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"

namespace plumb::maps::arch {
namespace {

constexpr double radius = 10;  // m

std::vector<Trial> trials(double thickness, double, const EngineConfig& config) {
  Trial trial{.scene = std::make_shared<const Scene>(scene_of("arch", {{"thickness", thickness}})), .dt = usual_dt};
  trial.watches = status(trial.scene, thickness * radius, stated_gap(config, usual_dt));
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "arch",
     .question = "How thin may the stones of a dry arch be, and what does more work give?",
     .x = {.name = "thickness over radius", .from = 0.16, .to = 0.07},
     .trials = trials,
     .boundaries = {{.name = "stands",
                     .grain = 0.0002,
                     .theory = [](const EngineConfig&, double) { return std::optional(0.1074); },
                     .source = "a line of thrust stays within the stones from t/R = 0.1075 on (Milankovitch); 0.1074 "
                               "for the scene's twenty",
                     .agreement = 0.002,
                     .natural = true}}}};

}  // namespace
}  // namespace plumb::maps::arch
