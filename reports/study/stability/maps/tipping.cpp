#include <cmath>

#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"
#include "scenarios/parts.h"

namespace plumb::maps::tipping {
namespace {

constexpr double height = 2;    // m
constexpr double duration = 4;  // s: a hundredth of a degree beyond the limit grows to half a radian in less

std::vector<Trial> trials(double angle, double shape, const EngineConfig& config) {
  Scene scene = scene_of("tipping", {{"angle", angle}, {"width", shape * height}, {"height", height}, {"friction", 4}});
  scene.duration = duration;
  Trial trial{.scene = std::make_shared<const Scene>(std::move(scene)), .dt = usual_dt};
  trial.watches = {topples(trial.scene, 0.3, height / 2), drifts(trial.scene, height / 2),
                   sinks(trial.scene, 0.1, stated_gap(config, usual_dt))};
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "tipping",
     .question = "Up to which slope does a box stand that is too rough to slide?",
     .x = {.name = "slope", .unit = "deg", .from = 5, .to = 59},
     .y = Axis{.name = "width over height", .from = 0.25, .to = 1.5},
     .typical = 0.5,
     .trials = trials,
     .boundaries = {
         {.name = "stands",
          .grain = 0.02,
          .theory = [](const EngineConfig&, double shape) { return std::optional(std::atan(shape) / degree); },
          .source = "tips once its centre is beyond its lower edge: arctan(b/h)",
          .agreement = 0.5,
          .natural = true}}}};

}  // namespace
}  // namespace plumb::maps::tipping
