// Controls whose surfaces are all alike, whatever the scene says.

#include "reference/controls/control.h"

namespace plumb::surface_controls {
namespace {

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

}  // namespace
}  // namespace plumb::surface_controls
