#include <cmath>

#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"
#include "reports/vec.h"
#include "scenarios/parts.h"

namespace plumb::maps::slope {
namespace {

constexpr double settled = 0.5;  // s, after which a box that sticks has found its place
constexpr double way = 0.005;    // m

// Beyond arctan(mu) by d radians a box slides with g (1 + mu^2) cos(a) d, and in the 1.5 s from 0.5 s on by 1.9 times
// that: by more than 5 mm from 0.02 degrees on.
Watch slides() {
  return {"drifts: after the first half second the box goes more than 5 mm",
          [from = std::optional<Vec>()](const Moment& now) mutable {
            const Vec at = now.states[1].position;
            if (!from && now.time >= settled) from = at;
            return from && length(at - *from) > way ? std::optional(Symptom{Fate::drifts, 1}) : std::nullopt;
          }};
}

std::vector<Trial> trials(double angle, double friction, const EngineConfig& config) {
  Trial trial{.scene = std::make_shared<const Scene>(scene_of("slope", {{"angle", angle}, {"friction", friction}})),
              .dt = usual_dt};
  trial.watches = {topples(trial.scene, 0.5, 30), sinks(trial.scene, 0.1, stated_gap(config, usual_dt)), slides()};
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "slope",
     .question = "Up to which slope does friction hold a box?",
     .x = {.name = "slope", .unit = "deg", .from = 1, .to = 46},
     .y = Axis{.name = "friction", .from = 0.1, .to = 0.9},
     .typical = 0.5,
     .trials = trials,
     .boundaries = {{.name = "sticks",
                     .grain = 0.02,
                     .theory = [](const EngineConfig&, double mu) { return std::optional(std::atan(mu) / degree); },
                     .source = "Coulomb: sticks up to arctan(mu)",
                     .agreement = 0.1,
                     .natural = true}}}};

}  // namespace
}  // namespace plumb::maps::slope
