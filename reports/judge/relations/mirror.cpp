#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::mirror {
namespace {

// Mechanics has no hand: x -> -x, with angles and spins negated and all shapes mirrored in their own frames. Signs
// are exact, but sums over mirrored corners may be taken in another order.
constexpr Congruence mirrored{.mirrored = true};

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "mirror",
     .unit = "m",
     .definition = "the mirrored scene moves as the mirror image, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{mapped(scene, mirrored), dt}};
     },
     .compare = [](const RelationRun& run,
                   std::span<const RelationRun> images) { return compare_congruent(run, images.front(), mirrored); }}};

}  // namespace
}  // namespace plumb::relations::mirror
