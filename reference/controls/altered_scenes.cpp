// Controls that are our engine in an altered scene, in which a law of mechanics has no effect.

#include <algorithm>

#include "reference/faults/altered_engine.h"
#include "reference/scene_facts.h"

namespace plumb::altered_scenes {
namespace {

// Some or all forces have no effect.

const Catalog<Control>::Entry weightless{
    in_altered_scene("weightless", "there is no gravity", [](Scene& scene) { scene.gravity = {}; })};

const Catalog<Control>::Entry half_gravity{
    in_altered_scene("half-gravity", "gravity is half as strong", [](Scene& scene) {
      scene.gravity = {scene.gravity.x / 2, scene.gravity.y / 2};
    })};

const Catalog<Control>::Entry coasting{in_altered_scene(
    "coasting", "bodies keep the velocities they start with: no force, joint or contact acts", [](Scene& scene) {
      scene.gravity = {};
      scene.forces.clear();
      scene.joints.clear();
      for (Body& body : scene.bodies) {
        body.layers = 0;
        body.linear_damping = body.angular_damping = 0;
      }
    })};

const Catalog<Control>::Entry intangible{
    in_altered_scene("intangible", "bodies pass through each other", [](Scene& scene) {
      for (Body& body : scene.bodies) body.layers = 0;
    })};

// Surfaces are all alike, whatever the scene says.

template <class Change>
void each_surface(Scene& scene, Change change) {
  for (Body& body : scene.bodies) {
    for (Shape& shape : body.shapes) change(shape.surface);
  }
}

const Catalog<Control>::Entry frictionless{in_altered_scene("frictionless", "there is no friction", [](Scene& scene) {
  each_surface(scene, [](Surface& of) { of.static_friction = of.dynamic_friction = 0; });
})};

const Catalog<Control>::Entry dull{in_altered_scene("no-restitution", "nothing bounces", [](Scene& scene) {
  each_surface(scene, [](Surface& of) { of.restitution = 0; });
})};

const Catalog<Control>::Entry elastic{in_altered_scene("all-restitution", "every impact is elastic", [](Scene& scene) {
  each_surface(scene, [](Surface& of) { of.restitution = 1; });
})};

// Joints, or bodies that are moved from outside, lack a law.

const Catalog<Control>::Entry unpowered{in_altered_scene("unpowered", "motors of joints turn freely", [](Scene& scene) {
  for (Joint& joint : scene.joints) {
    if (auto* hinge = std::get_if<Revolute>(&joint)) hinge->motor.reset();
    if (auto* slider = std::get_if<Prismatic>(&joint)) slider->motor.reset();
  }
})};

const Catalog<Control>::Entry unlimited{in_altered_scene("unlimited", "joints have no limits", [](Scene& scene) {
  for (Joint& joint : scene.joints) {
    if (auto* hinge = std::get_if<Revolute>(&joint)) hinge->limits.reset();
    if (auto* slider = std::get_if<Prismatic>(&joint)) slider->limits.reset();
  }
})};

const Catalog<Control>::Entry jointless{
    in_altered_scene("jointless", "joints hold nothing together", [](Scene& scene) { scene.joints.clear(); })};

const Catalog<Control>::Entry pathless{
    in_altered_scene("pathless", "kinematic bodies leave their paths and go straight on", [](Scene& scene) {
      for (Body& body : scene.bodies) body.path.reset();
    })};

// Bodies do not turn as their shapes say.

const Catalog<Control>::Entry no_rotation{in_altered_scene("no-rotation", "no body turns", [](Scene& scene) {
  for (Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    body.fixed_rotation = true;
    body.angular_velocity = 0;
  }
})};

bool is_disc(const Body& body) { return body.type == BodyType::dynamic && only_shape<Circle>(body) != nullptr; }

// Moments of inertia follow from shapes, so only a mutated solver can have others. Without a disc it is our engine.
const Catalog<Control>::Entry hoop{{.name = "hoop-for-disc",
                                    .about = "a disc has the moment of inertia of a hoop, m r^2",
                                    .build = [](const Scene& scene, Settings settings) {
                                      if (std::any_of(scene.bodies.begin(), scene.bodies.end(), is_disc)) {
                                        settings["solver"] = "inertia-of-hoop";
                                      }
                                      return build_ours(scene, settings);
                                    }}};

}  // namespace
}  // namespace plumb::altered_scenes
