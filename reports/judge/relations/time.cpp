#include <algorithm>
#include <string>
#include <variant>

#include "reference/reduced_model.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb::relations::time {
namespace {

// Without friction, damping and inelastic impacts mechanics has no arrow of time: from the end of a run, with all
// velocities reversed, bodies go back to the start. Both ways are off by the method's own error, which the way back
// amplifies.
// Anchors of joints are where their bodies have taken them.
Scene reversed(const Scene& scene, std::span<const BodyState> end) {
  Scene image = scene;
  for (std::size_t i = 0; i < image.bodies.size(); ++i) {
    Body& body = image.bodies[i];
    if (body.type == BodyType::fixed) continue;
    body.angle = end[i].angle;
    body.position = end[i].position - rotated(mass_of(body).center, body.angle);
    body.velocity = -1 * end[i].velocity;
    body.angular_velocity = -end[i].angular_velocity;
  }
  const std::vector<BodyState> start = initial_states(scene);
  const auto turned = [&](std::size_t body, Vec v) { return rotated(v, end[body].angle - start[body].angle); };
  const JointMap carried{
      .point = [&](std::size_t body,
                   Vec point) { return end[body].position + turned(body, point - start[body].position); },
      .direction = turned};
  for (Joint& joint : image.joints) joint = mapped(joint, carried);
  return image;
}

// A run ends with the first step that reaches the scene's end, or goes beyond it.
bool nothing_meets_in_run(Scene scene, double dt) {
  scene.duration += dt;
  return !why_none_meet(scene).empty();
}

std::string excludes(const Scene& scene, const Stepping& stepping) {
  const bool nothing_meets = nothing_meets_in_run(scene, stepping.dt);
  for (const Body& body : scene.bodies) {
    if (body.path) return "paths begin at the start, wherever they have led to";
    if (body.linear_damping > 0 || body.angular_damping > 0) return "damping has an arrow of time";
    for (const Shape& shape : body.shapes) {
      if (nothing_meets) break;
      if (shape.surface.static_friction > 0 || shape.surface.dynamic_friction > 0)
        return "friction has an arrow of time";
      if (shape.surface.restitution < 1) return "inelastic impacts have an arrow of time";
    }
  }
  for (const Joint& joint : scene.joints) {
    const JointFacts facts = facts_of(joint);
    if (facts.motor != nullptr) return "a motor whose strength is limited brakes as it drives";
    if (facts.limits != nullptr) return "a joint's limits stop bodies inelastically";
    if (facts.damping > 0) return "damping has an arrow of time";
  }
  for (const Force& force : scene.forces) {
    const auto* spring = std::get_if<Spring>(&force);
    if (spring != nullptr && spring->damping > 0) return "damping has an arrow of time";
  }
  return "";
}

RelationCheck compare(const RelationRun& run, std::span<const RelationRun> images) {
  const RelationRun& back = images.front();
  const std::size_t last = run.trace.size() - 1;
  const auto poses = [&](std::size_t moment, std::size_t body) { return run.trace.states(last - moment)[body]; };
  const std::vector<double> there = pose_rounding(run);
  std::vector<double> rounding = pose_rounding(back);
  for (double& one : rounding) one += there.back();
  return compare_poses(back, std::min(back.trace.size(), run.trace.size()), poses,
                       explained_by_method(back, rounding, run.stepping, back.stepping));
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "time",
     .unit = "m",
     .definition = "without friction, damping and inelastic impacts, bodies whose velocities are reversed go back to "
                   "where they came from, but for the method's own error",
     .excludes = excludes,
     .images = [](const Scene& scene, const Trace& trace, double dt) -> std::vector<Image> {
       return {{reversed(scene, trace.states(trace.size() - 1)), dt}};
     },
     .compare = compare}};

}  // namespace
}  // namespace plumb::relations::time
