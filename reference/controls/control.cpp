#include "reference/controls/control.h"

#include <utility>

namespace plumb {

Engine engine_of(const Control& control) {
  Engine made = *Catalog<Engine>::find("impulse");
  made.name = control.name;
  made.about = control.about;
  made.build = control.build;
  made.chooses = nullptr;
  return made;
}

Control in_altered_scene(std::string name, std::string about, void (*alter)(Scene&)) {
  return {.name = std::move(name), .about = std::move(about), .build = [alter](Scene scene, const Settings& settings) {
            alter(scene);
            return build_ours(scene, settings);
          }};
}

}  // namespace plumb
