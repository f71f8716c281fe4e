#include "scenarios/scene/materials.h"

#include <array>

#include "scenarios/parts.h"

namespace plumb {

// Densities and restitutions are those of Randy Gaul's "How to Create a Custom 2D Physics Engine", part 2 (2013), whose
// "static" is what immovable things are made of. He lists no friction: 0.6 for all, within the 0.4 ... 0.7 that tables
// give for dry wood and stone.
std::span<const Material> materials() {
  constexpr double friction = 0.6;
  static const std::array<Material, 7> table{{{"rock", surface(friction, 0.1, 0.6)},
                                              {"wood", surface(friction, 0.2, 0.3)},
                                              {"metal", surface(friction, 0.05, 1.2)},
                                              {"bouncy-ball", surface(friction, 0.8, 0.3)},
                                              {"super-ball", surface(friction, 0.95, 0.3)},
                                              {"pillow", surface(friction, 0.2, 0.1)},
                                              {"static", surface(friction, 0.4, 0)}}};
  return table;
}

const Surface* find_material(std::string_view name) {
  for (const Material& material : materials()) {
    if (material.name == name) return &material.surface;
  }
  return nullptr;
}

}  // namespace plumb
