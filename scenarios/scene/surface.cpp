#include "scenarios/scene/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {
namespace {

double mixed(FrictionMixing rule, double a, double b) {
  switch (rule) {
    case FrictionMixing::geometric:
      return std::sqrt(a * b);
    case FrictionMixing::pythagorean:
      return std::sqrt(a * a + b * b);
    case FrictionMixing::average:
      return (a + b) / 2;
    case FrictionMixing::min:
      return std::min(a, b);
    case FrictionMixing::max:
      return std::max(a, b);
    case FrictionMixing::multiply:
      return a * b;
  }
  return 0;
}

}  // namespace

// Densities and restitutions are those of the article, part 2 (2013), whose "static" is the material of immovable
// things. It lists no friction: 0.6 for all, within the 0.4 ... 0.7 that tables give for dry wood and stone.
std::span<const NamedSurface> materials() {
  constexpr double friction = 0.6;
  static const std::array<NamedSurface, 7> table{{{"rock", surface(friction, 0.1, 0.6)},
                                                  {"wood", surface(friction, 0.2, 0.3)},
                                                  {"metal", surface(friction, 0.05, 1.2)},
                                                  {"bouncy-ball", surface(friction, 0.8, 0.3)},
                                                  {"super-ball", surface(friction, 0.95, 0.3)},
                                                  {"pillow", surface(friction, 0.2, 0.1)},
                                                  {"static", surface(friction, 0.4, 0)}}};
  return table;
}

const Surface* find_material(std::string_view name) {
  for (const NamedSurface& material : materials()) {
    if (material.name == name) return &material.surface;
  }
  return nullptr;
}

double mixed_static_friction(const Mixing& mixing, const Surface& a, const Surface& b) {
  return mixed(mixing.friction, a.static_friction, b.static_friction);
}

double mixed_dynamic_friction(const Mixing& mixing, const Surface& a, const Surface& b) {
  return mixed(mixing.friction, a.dynamic_friction, b.dynamic_friction);
}

double mixed_restitution(const Mixing& mixing, const Surface& a, const Surface& b) {
  switch (mixing.restitution) {
    case RestitutionMixing::max:
      return std::max(a.restitution, b.restitution);
    case RestitutionMixing::min:
      return std::min(a.restitution, b.restitution);
    case RestitutionMixing::average:
      return (a.restitution + b.restitution) / 2;
    case RestitutionMixing::multiply:
      return a.restitution * b.restitution;
  }
  return 0;
}

}  // namespace plumb
