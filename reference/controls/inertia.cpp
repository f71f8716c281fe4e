// Controls whose bodies do not turn as their shapes say.

#include <algorithm>

#include "reference/controls/control.h"
#include "reference/scene_facts.h"

namespace plumb::inertia_controls {
namespace {

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
}  // namespace plumb::inertia_controls
