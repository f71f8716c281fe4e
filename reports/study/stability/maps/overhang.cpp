#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"

namespace plumb::maps::overhang {
namespace {

constexpr double thin = 0.5;  // m, a block's height

std::vector<Trial> trials(double fraction, double blocks, const EngineConfig& config) {
  Trial trial{
      .scene = std::make_shared<const Scene>(scene_of("overhang", {{"fraction", fraction}, {"blocks", blocks}})),
      .dt = usual_dt};
  trial.watches = status(trial.scene, thin, stated_gap(config, usual_dt));
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "overhang",
     .question = "How far can blocks be stepped out, as a share of the harmonic series?",
     .x = {.name = "share of the limit", .from = 0.7, .to = 1.2},
     .y = Axis{.name = "blocks", .from = 2, .to = 16, .whole = true},
     .typical = 4,
     .trials = trials,
     .boundaries = {{.name = "stands",
                     .grain = 0.001,
                     .theory = [](const EngineConfig&, double) { return std::optional(1.0); },
                     .source = "n blocks stand up to an overhang of (L/2) sum 1/k",
                     .agreement = 0.01,
                     .natural = true}}}};

}  // namespace
}  // namespace plumb::maps::overhang
