#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::mass {
namespace {

// Equations of motion are homogeneous in mass: with every mass and every force multiplied alike, all accelerations
// stay, impulses grow as masses do, and friction and restitution are ratios. The factor is no power of two, so that
// every product is rounded otherwise; nothing else may differ.
constexpr double factor = 10;

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "mass",
     .unit = "m",
     .definition = "with all masses and forces ten times as large, a scene moves in the same way, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{with_masses(scene, factor), dt}};
     },
     .compare = [](const RelationRun& run,
                   std::span<const RelationRun> images) { return compare_congruent(run, images.front(), {}); }}};

}  // namespace
}  // namespace plumb::relations::mass
