// Maps of structures of blocks that should stand still.

#include "reports/study/stability/map.h"

namespace plumb::maps::stacks {
namespace {

// `size`: m, of the structure's blocks.
std::vector<Trial> structure_trial(Scene scene, double size, const EngineConfig& config) {
  Trial trial{.scene = std::make_shared<const Scene>(std::move(scene)), .dt = usual_dt};
  trial.detectors = structure_detectors(trial.scene, size, stated_gap(config, usual_dt));
  return {trial};
}

std::vector<Trial> arch_trials(double thickness, double, const EngineConfig& config) {
  constexpr double radius = 10;  // m
  return structure_trial(catalog_scene("arch", {{"thickness", thickness}}), thickness * radius, config);
}

std::vector<Trial> overhang_trials(double fraction, double blocks, const EngineConfig& config) {
  constexpr double height = 0.5;  // m, of a block
  return structure_trial(catalog_scene("overhang", {{"fraction", fraction}, {"blocks", blocks}}), height, config);
}

std::vector<Trial> stack_trials(double boxes, double, const EngineConfig& config) {
  return structure_trial(catalog_scene("stacking", {{"boxes", boxes}}), 1, config);
}

std::vector<Trial> mass_ratio_trials(double ratio, double, const EngineConfig& config) {
  Scene scene = catalog_scene("stacking", {{"boxes", 3}, {"duration", 5}});
  scene.bodies.back().shapes[0].surface.density = ratio;
  return structure_trial(std::move(scene), 1, config);
}

const Catalog<StabilityMap>::Entry arch{
    {.name = "arch",
     .question = "How thin can the stones of a dry arch be, and does more work help?",
     .x = {.name = "thickness over radius", .from = 0.16, .to = 0.07},
     .trials = arch_trials,
     .boundaries = {{.name = "stands",
                     .resolution = 0.0002,
                     .theory = [](const EngineConfig&, double) { return std::optional(0.1074); },
                     .source = "a line of thrust stays within the stones for t/R of at least 0.1075 (Milankovitch); "
                               "0.1074 for the scene's twenty stones",
                     .agreement = 0.002,
                     .natural = true}}}};

const Catalog<StabilityMap>::Entry overhang{
    {.name = "overhang",
     .question = "How far can a stack of blocks overhang, as a fraction of the harmonic series?",
     .x = {.name = "fraction of the limit", .from = 0.7, .to = 1.2},
     .y = Axis{.name = "blocks", .from = 2, .to = 16, .whole = true},
     .typical = 4,
     .trials = overhang_trials,
     .boundaries = {{.name = "stands",
                     .resolution = 0.001,
                     .theory = [](const EngineConfig&, double) { return std::optional(1.0); },
                     .source = "n blocks stand up to an overhang of (L/2) sum 1/k",
                     .agreement = 0.01,
                     .natural = true}}}};

const Catalog<StabilityMap>::Entry stack{
    {.name = "stack",
     .question = "How many boxes can stand on each other for ten seconds, and does more work help?",
     .x = {.name = "boxes", .from = 1, .to = 100, .logarithmic = true, .whole = true},
     .trials = stack_trials,
     .boundaries = {{.name = "stands"}}}};

const Catalog<StabilityMap>::Entry mass_ratio{{.name = "mass-ratio",
                                               .question = "How heavy can a box be that stands on two light ones?",
                                               .x = {.name = "mass ratio", .from = 1, .to = 1e5, .logarithmic = true},
                                               .trials = mass_ratio_trials,
                                               .boundaries = {{.name = "stands", .resolution = 0.02}}}};

}  // namespace
}  // namespace plumb::maps::stacks
