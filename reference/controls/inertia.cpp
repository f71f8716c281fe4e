// Controls whose bodies do not turn as their shapes say.

#include "reference/controls/control.h"

namespace plumb::inertia_controls {
namespace {

const Catalog<Control>::Entry no_rotation{in_altered_scene("no-rotation", "no body turns", [](Scene& scene) {
  for (Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    body.fixed_rotation = true;
    body.angular_velocity = 0;
  }
})};

// Moments of inertia follow from shapes, so only a mutated solver can have others.
const Catalog<Control>::Entry hoop{{.name = "hoop-for-disc",
                                    .about = "a disc has the moment of inertia of a hoop, m r^2",
                                    .build = [](const Scene& scene, Settings settings) {
                                      settings["solver"] = "inertia-of-hoop";
                                      return build_ours(scene, settings);
                                    }}};

}  // namespace
}  // namespace plumb::inertia_controls
