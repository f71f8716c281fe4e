#include <algorithm>
#include <cmath>
#include <string>

#include "reference/scene_facts.h"
#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"
#include "scenarios/scene/vec.h"

namespace plumb::relations::galilei {
namespace {

// No experiment tells rest from uniform motion: every velocity plus u, and every place plus u t. Fixed bodies become
// kinematic ones. Engines refuse half-spaces that move, so those of both runs are made of walls as large as what they
// can meet. A method may evaluate contacts where the bodies were and where they will be, which a moving floor changes
// within its step: each run may be off by the method's own error.
Vec boost_of(const Scene& scene) {
  double speed = std::sqrt(length(scene.gravity) * smallest_body(scene));
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic) speed = std::max(speed, length(body.velocity));
  }
  if (speed == 0) speed = smallest_body(scene);  // m/s: its size in a second
  return {1.1 * speed, 0.7 * speed};
}

bool has_half_space(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
    return std::any_of(body.shapes.begin(), body.shapes.end(),
                       [](const Shape& shape) { return std::holds_alternative<HalfSpace>(shape.geometry); });
  });
}

// Walls reach as far as the farthest body of the run and the arrangement's extent, both ways from the middle of the
// half-space's boundary nearest to the world's origin.
Scene walled(const Scene& scene, const Trace& trace) {
  double reach = 2 * extent_of(scene);
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (scene.bodies[i].type == BodyType::dynamic)
        reach = std::max(reach, 2 * length(trace.states(moment)[i].position));
    }
  }
  Scene image = scene;
  for (Body& body : image.bodies) {
    const double wide = 2 * (reach + length(body.position));
    for (Shape& shape : body.shapes) {
      const auto* half_space = std::get_if<HalfSpace>(&shape.geometry);
      if (half_space == nullptr) continue;
      const double depth = wide / 2;
      const Vec normal = half_space->normal;
      shape.geometry = Box{.size = {wide, depth},
                           .center = (half_space->offset - depth / 2) * normal,
                           .angle = std::atan2(-normal.x, normal.y)};
    }
  }
  return image;
}

std::string excludes(const Scene& scene, const Stepping&) {
  for (const Body& body : scene.bodies) {
    if (body.linear_damping > 0) return "air that stands still damps velocities";
  }
  for (const Force& force : scene.forces) {
    const auto* spring = std::get_if<Spring>(&force);
    if (spring != nullptr && !spring->a) return "a spring ends at a point of the world, which cannot move";
  }
  return "";
}

std::vector<Image> images(const Scene& scene, const Trace& trace, double dt) {
  if (!has_half_space(scene)) return {{boosted(scene, boost_of(scene)), dt}};
  const Scene at_rest = walled(scene, trace);
  return {{at_rest, dt}, {boosted(at_rest, boost_of(scene)), dt}};
}

RelationCheck compare(const RelationRun& original, std::span<const RelationRun> images) {
  const RelationRun& run = images.size() == 1 ? original : images.front();
  const RelationRun& image = images.back();
  const Vec u = boost_of(original.scene);
  const auto poses = [&](std::size_t moment, std::size_t body) {
    BodyState state = image.trace.states(moment)[body];
    state.position = state.position - run.trace.time(moment) * u;
    return state;
  };
  return compare_poses(
      run, run.trace.size(), poses,
      explained_by_method(run, sum_of(pose_rounding(run), pose_rounding(image)), run.stepping, image.stepping));
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "galilei",
     .unit = "m",
     .definition = "seen from a train at constant speed, a scene moves in the same way, but for round-off and the "
                   "method's own error",
     .excludes = excludes,
     .images = images,
     .compare = compare}};

}  // namespace
}  // namespace plumb::relations::galilei
