#include <algorithm>

#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::stranger {
namespace {

// A body that touches nothing and pulls at nothing is in no equation of the others. It is listed last, shares no layer
// with any body, weighs nothing, turns, and is damped: one that an engine might treat all bodies alike for. An engine
// may keep its bodies in an order that a further one changes, so the others' sums may be rounded, and its iterations
// ordered, in another way; an engine that does not is the same to the bit. It is far from what attracts all bodies,
// too, or it would fall into that within the scene.
Scene with_stranger(const Scene& scene) {
  Scene image = scene;
  const double extent = extent_of(scene);
  Vec middle;
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic) middle = body.position;
  }
  double far = extent;
  for (const Body& body : scene.bodies) far = std::max(far, length(body.position - middle));
  image.bodies.push_back({.name = "the stranger",
                          .position = {middle.x + 20 * far, middle.y + 10 * far},
                          .angular_velocity = 1,
                          .gravity_scale = 0,
                          .layers = 0,
                          .linear_damping = 0.1,
                          .angular_damping = 0.1,
                          .shapes = {{Circle{extent / 2}, surface(0.5, 0.5)}}});
  return image;
}

std::string excludes(const Scene& scene, const Stepping&) {
  const bool pulled = std::any_of(scene.forces.begin(), scene.forces.end(), [](const Force& force) {
    const auto* attraction = std::get_if<Attraction>(&force);
    return attraction != nullptr && attraction->mutual;
  });
  return pulled ? "every body pulls at the centre of a mutual attraction" : "";
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "stranger",
     .unit = "m",
     .definition = "one more body, far away, that touches nothing changes nothing",
     .excludes = excludes,
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {{with_stranger(scene), dt}};
     },
     .compare =
         [](const RelationRun& run, std::span<const RelationRun> images) {
           const RelationRun& image = images.front();
           const auto poses = [&](std::size_t moment, std::size_t body) { return image.trace.states(moment)[body]; };
           const std::vector<double> rounding = pose_rounding(run);
           std::vector<Allowance> allowances =
               explained_by_rounding(run, sum_of(rounding, rounding), residue_of(run.stepping));
           // Without iterations there is no order that may change, and so no tie to be decided otherwise.
           if (!residue_of(run.stepping)) allowances.pop_back();
           allowances.insert(allowances.begin(),
                             Allowance{"nothing: the same to the bit", [](std::size_t, std::size_t) { return 0.0; }});
           return compare_poses(run, run.trace.size(), poses, allowances);
         }}};

}  // namespace
}  // namespace plumb::relations::stranger
