#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"

namespace plumb::maps::chain {
namespace {

constexpr double link = 0.5;     // m
constexpr double stretch = 1.1;  // of its length, that a chain may have given way by

std::vector<Trial> trials(double ratio, double links, const EngineConfig&) {
  Trial trial{.scene = std::make_shared<const Scene>(
                  scene_of("hanging-chain", {{"ratio", ratio}, {"links", links}, {"angle", 60}})),
              .dt = usual_dt};
  trial.watches = {gives_way(trial.scene, 0, trial.scene->bodies.size() - 1, stretch * link * links),
                   gains_energy(trial.scene, 0.1)};
  return {trial};
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "chain",
     .question = "How heavy a load can swing on a chain of light links?",
     .x = {.name = "mass ratio", .from = 1, .to = 10000, .logarithmic = true},
     .y = Axis{.name = "links", .from = 1, .to = 32, .logarithmic = true, .whole = true},
     .typical = 10,
     .trials = trials,
     .boundaries = {{.name = "holds", .grain = 0.02}}}};

}  // namespace
}  // namespace plumb::maps::chain
