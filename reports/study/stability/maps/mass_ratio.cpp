#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"

namespace plumb::maps::mass_ratio {
namespace {

std::vector<Trial> trials(double ratio, double, const EngineConfig& config) {
  Scene scene = scene_of("stacking", {{"boxes", 3}, {"duration", 5}});
  scene.bodies.back().shapes[0].surface.density = ratio;
  Trial trial{.scene = std::make_shared<const Scene>(std::move(scene)), .dt = usual_dt};
  trial.watches = status(trial.scene, 1, stated_gap(config, usual_dt));
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{{.name = "mass-ratio",
                                          .question = "How heavy may a box be that stands on two light ones?",
                                          .x = {.name = "mass ratio", .from = 1, .to = 1e5, .logarithmic = true},
                                          .trials = trials,
                                          .boundaries = {{.name = "stands", .grain = 0.02}}}};

}  // namespace
}  // namespace plumb::maps::mass_ratio
