#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::turn {
namespace {

// Space is isotropic: a scene turned with its gravity moves in the same way. The angle is none at which boxes fit
// their bounds, or a sine is a short number. Coordinates and angles are rounded otherwise; nothing else may differ.
constexpr Congruence turned{.angle = 0.7};  // rad

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "turn",
     .unit = "m",
     .definition = "a scene turned together with its gravity moves in the same way, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{mapped(scene, turned), dt}};
     },
     .compare = [](const RelationRun& run,
                   std::span<const RelationRun> images) { return compare_congruent(run, images.front(), turned); }}};

}  // namespace
}  // namespace plumb::relations::turn
