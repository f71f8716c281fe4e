// Maps of a box on a slope: it slides, or it tips over.

#include <cmath>

#include "reports/study/stability/map.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::maps::friction {
namespace {

// Past arctan(mu) by d radians a box slides with g (1 + mu^2) cos(a) d, and in the 1.5 s after the first half second by
// 1.9 times that: by more than 5 mm for d of at least 0.02 degrees.
Detector slide_detector() {
  constexpr double settled = 0.5;     // s, after which a box that sticks has come to rest
  constexpr double distance = 0.005;  // m
  return {"drifts: after the first half second the box moves by more than 5 mm",
          [from = std::optional<Vec>()](const ObservedStep& now) mutable {
            const Vec at = now.states[1].position;
            if (!from && now.time >= settled) from = at;
            return from && length(at - *from) > distance ? std::optional(DetectorFinding{FailureMode::drifts, 1})
                                                         : std::nullopt;
          }};
}

std::vector<Trial> slope_trials(double angle, double mu, const EngineConfig& config) {
  Trial trial{.scene = std::make_shared<const Scene>(catalog_scene("slope", {{"angle", angle}, {"friction", mu}})),
              .dt = usual_dt};
  trial.detectors = {topple_detector(trial.scene, 0.5, 30),
                     sink_detector(trial.scene, 0.1, stated_gap(config, usual_dt)), slide_detector()};
  return {trial};
}

std::vector<Trial> tipping_trials(double angle, double shape, const EngineConfig& config) {
  constexpr double height = 2;    // m
  constexpr double duration = 4;  // s: long enough for 0.01 degrees beyond the limit to grow to half a radian
  Scene scene =
      catalog_scene("tipping", {{"angle", angle}, {"width", shape * height}, {"height", height}, {"friction", 4}});
  scene.duration = duration;
  Trial trial{.scene = std::make_shared<const Scene>(std::move(scene)), .dt = usual_dt};
  trial.detectors = {topple_detector(trial.scene, 0.3, height / 2), drift_detector(trial.scene, height / 2),
                     sink_detector(trial.scene, 0.1, stated_gap(config, usual_dt))};
  return {trial};
}

const Catalog<StabilityMap>::Entry slope{
    {.name = "slope",
     .question = "Up to which slope does friction hold a box?",
     .x = {.name = "slope", .unit = "deg", .from = 1, .to = 46},
     .y = Axis{.name = "friction", .from = 0.1, .to = 0.9},
     .typical = 0.5,
     .trials = slope_trials,
     .boundaries = {{.name = "sticks",
                     .resolution = 0.02,
                     .theory = [](const EngineConfig&, double mu) { return std::optional(std::atan(mu) / degree); },
                     .source = "Coulomb: sticks up to arctan(mu)",
                     .agreement = 0.1,
                     .natural = true}}}};

const Catalog<StabilityMap>::Entry tipping{
    {.name = "tipping",
     .question = "Up to which slope does a box stand that is too rough to slide?",
     .x = {.name = "slope", .unit = "deg", .from = 5, .to = 59},
     .y = Axis{.name = "width over height", .from = 0.25, .to = 1.5},
     .typical = 0.5,
     .trials = tipping_trials,
     .boundaries = {
         {.name = "stands",
          .resolution = 0.02,
          .theory = [](const EngineConfig&, double shape) { return std::optional(std::atan(shape) / degree); },
          .source = "tips once its centre is beyond its lower edge: arctan(b/h)",
          .agreement = 0.5,
          .natural = true}}}};

}  // namespace
}  // namespace plumb::maps::friction
