#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scenarios/scene/scene.h"

namespace plumb {

struct Material {
  std::string name;
  Surface surface;
};

/// What a scene file may call by name: rock, wood, metal, bouncy-ball, super-ball, pillow, static.
std::span<const Material> materials();

/// The surface of that name, or null.
const Surface* find_material(std::string_view name);

}  // namespace plumb
