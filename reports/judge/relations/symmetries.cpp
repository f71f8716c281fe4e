#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

// Symmetries of mechanics under which a scene's image differs from it by round-off alone, or by what a solver that
// goes through lists leaves.
namespace plumb::relations::symmetries {
namespace {

// Space is homogeneous: no law knows where the origin is. The image's coordinates differ, and with them how they are
// rounded; nothing else may. The way is no multiple of any cell or step, and about as large as the scene, so that its
// coordinates stay about as large.
Congruence moved_away(const Scene& scene) {
  const double extent = extent_of(scene);
  return {.shift = {3.7 * extent, -2.3 * extent}};
}

const Catalog<MetamorphicRelation>::Entry shift{
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

// Space is isotropic: a scene turned with its gravity moves in the same way. The angle is none at which boxes fit
// their bounds, or a sine is a short number. Coordinates and angles are rounded otherwise; nothing else may differ.
constexpr Congruence turned{.angle = 0.7};  // rad

const Catalog<MetamorphicRelation>::Entry turn{
    {.name = "turn",
     .unit = "m",
     .definition = "a scene turned together with its gravity moves in the same way, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{mapped(scene, turned), dt}};
     },
     .compare = [](const RelationRun& run,
                   std::span<const RelationRun> images) { return compare_congruent(run, images.front(), turned); }}};

// Mechanics has no hand: x -> -x, with angles and spins negated and all shapes mirrored in their own frames. Signs
// are exact, but sums over mirrored corners may be taken in another order.
constexpr Congruence mirrored{.mirrored = true};

const Catalog<MetamorphicRelation>::Entry mirror{
    {.name = "mirror",
     .unit = "m",
     .definition = "the mirrored scene moves as the mirror image, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{mapped(scene, mirrored), dt}};
     },
     .compare = [](const RelationRun& run,
                   std::span<const RelationRun> images) { return compare_congruent(run, images.front(), mirrored); }}};

// Equations of motion are homogeneous in mass: with every mass and every force multiplied alike, all accelerations
// stay, impulses grow as masses do, and friction and restitution are ratios. The heavier is no power of two, so that
// every product is rounded otherwise; nothing else may differ.
constexpr double heavier = 10;

const Catalog<MetamorphicRelation>::Entry mass{
    {.name = "mass",
     .unit = "m",
     .definition = "with all masses and forces ten times as large, a scene moves in the same way, but for round-off",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{in_units(scene, {.mass = heavier}), dt}};
     },
     .compare = [](const RelationRun& run,
                   std::span<const RelationRun> images) { return compare_congruent(run, images.front(), {}); }}};

// Nature reads no lists. Sums over bodies, contacts and joints are rounded in another order; a solver that iterates
// over them a stated number of times may leave what it leaves elsewhere (see `residue_of`), in either run.
const Catalog<MetamorphicRelation>::Entry order{
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
}  // namespace plumb::relations::symmetries
