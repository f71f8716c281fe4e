// Controls whose joints, or bodies that are moved from outside, lack a law.

#include "reference/controls/control.h"

namespace plumb::joint_controls {
namespace {

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

const Catalog<Control>::Entry pathless{
    in_altered_scene("pathless", "kinematic bodies leave their paths and go straight on", [](Scene& scene) {
      for (Body& body : scene.bodies) body.path.reset();
    })};

}  // namespace
}  // namespace plumb::joint_controls
