// Controls on which some or all forces have no effect.

#include "reference/controls/control.h"

namespace plumb::force_controls {
namespace {

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

}  // namespace
}  // namespace plumb::force_controls
