#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::shift {
namespace {

// Space is homogeneous: no law knows where the origin is. The image's coordinates differ, and with them how they are
// rounded; nothing else may. The way is no multiple of any cell or step, and about as large as the scene, so that its
// coordinates stay about as large.
Congruence moved_away(const Scene& scene) {
  const double extent = extent_of(scene);
  return {.shift = {3.7 * extent, -2.3 * extent}};
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "shift",
     .unit = "m",
     .definition = "a scene elsewhere moves in the same way, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{mapped(scene, moved_away(scene)), dt}};
     },
     .compare =
         [](const RelationRun& run, std::span<const RelationRun> images) {
           return compare_congruent(run, images.front(), moved_away(run.scene));
         }}};

}  // namespace
}  // namespace plumb::relations::shift
