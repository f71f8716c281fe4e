#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::order {
namespace {

// Nature reads no lists. Sums over bodies, contacts and joints are rounded in another order; a solver that sweeps over
// them a stated number of times may leave what it leaves elsewhere (see `residue_of`), in either run.
const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "order",
     .unit = "m",
     .definition = "a scene whose bodies, shapes, joints and forces are listed from last to first moves in the same "
                   "way, but for round-off and what a solver's stated iterations leave",
     .excludes = [](const Scene& scene, const Stepping&) { return scene.bodies.empty() ? "has no body" : ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{listed_backwards(scene), dt}};
     },
     .compare =
         [](const RelationRun& run, std::span<const RelationRun> images) {
           const RelationRun& image = images.front();
           const auto poses = [&](std::size_t moment, std::size_t body) {
             return image.trace.states(moment)[run.scene.bodies.size() - 1 - body];
           };
           return compare_poses(
               run, run.trace.size(), poses,
               explained_by_rounding(run, sum_of(pose_rounding(run), pose_rounding(image)), residue_of(run.stepping)));
         }}};

}  // namespace
}  // namespace plumb::relations::order
