#pragma once

#include <span>
#include <string>
#include <string_view>

/// Surfaces, named materials and the rules that combine two surfaces in a contact.
namespace plumb {

struct Surface {
  double density = 1;          // kg/m^2
  double static_friction = 0;  // Coulomb coefficient while sticking
  double dynamic_friction =
      0;                   // Coulomb coefficient while sliding; equals the static one unless a scene says otherwise
  double restitution = 0;  // 0 ... 1
};

/// A surface with the same coefficient of friction for sticking and sliding.
inline Surface surface(double friction, double restitution, double density = 1) {
  return {.density = density, .static_friction = friction, .dynamic_friction = friction, .restitution = restitution};
}

/// A material.
struct NamedSurface {
  std::string name;
  Surface surface;
};

/// The materials that a scene file can refer to by name: rock, wood, metal, bouncy-ball, super-ball, pillow, static.
std::span<const NamedSurface> materials();

/// The surface of the material with that name, or null if there is none.
const Surface* find_material(std::string_view name);

enum class FrictionMixing { geometric, pythagorean, average, min, max, multiply };
enum class RestitutionMixing { max, min, average, multiply };

struct Mixing {
  FrictionMixing friction = FrictionMixing::geometric;
  RestitutionMixing restitution = RestitutionMixing::max;
};

/// The coefficients that every engine must use for a contact between two surfaces.
double mixed_static_friction(const Mixing&, const Surface&, const Surface&);
double mixed_dynamic_friction(const Mixing&, const Surface&, const Surface&);
double mixed_restitution(const Mixing&, const Surface&, const Surface&);

}  // namespace plumb
