#include "reference/reduced.h"

#include <utility>

namespace plumb {

std::vector<Option> reductions() {
  return {{.key = "rotation",
           .value = "on",
           .choices = {{"on", "bodies turn"}, {"off", "no dynamic body ever turns, as if its inertia were infinite"}},
           .about = "of bodies"},
          {.key = "friction",
           .value = "full",
           .choices = {{"full", "static and dynamic, as the scene has it"},
                       {"dynamic", "what sticks holds no better than what slides"},
                       {"off", "all is smooth"}},
           .about = "of contacts"},
          {.key = "restitution",
           .value = "on",
           .choices = {{"on", "as the scene has it"}, {"off", "nothing bounces"}},
           .about = "of contacts"}};
}

Scene reduced(Scene scene, const Settings& settings) {
  const bool turns = settings.at("rotation") == "on";
  const std::string& friction = settings.at("friction");
  const bool bounces = settings.at("restitution") == "on";
  for (Body& body : scene.bodies) {
    if (!turns && body.type == BodyType::dynamic) {
      body.fixed_rotation = true;
      body.angular_velocity = 0;
    }
    for (Shape& shape : body.shapes) {
      Surface& surface = shape.surface;
      if (friction != "full") surface.static_friction = surface.dynamic_friction;
      if (friction == "off") surface.static_friction = surface.dynamic_friction = 0;
      if (!bounces) surface.restitution = 0;
    }
  }
  return scene;
}

}  // namespace plumb
