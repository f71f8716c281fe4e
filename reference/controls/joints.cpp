// Controls whose joints lack a law.

#include "reference/controls/control.h"

namespace plumb::joint_controls {
namespace {

const Catalog<Control>::Entry unpowered{in_altered_scene("unpowered", "motors of joints turn freely", [](Scene& scene) {
  for (Joint& joint : scene.joints) {
    if (auto* hinge = std::get_if<Revolute>(&joint)) hinge->motor.reset();
    if (auto* slider = std::get_if<Prismatic>(&joint)) slider->motor.reset();
  }
})};

}  // namespace
}  // namespace plumb::joint_controls
