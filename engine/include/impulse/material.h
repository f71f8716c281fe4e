#pragma once

#include <span>
#include <string_view>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The surface and density of a shape.
struct Material {
  Real density = 1;                               // kg/m^2; 0 gives no mass
  Real static_friction = static_cast<Real>(.6);   // Coulomb coefficient while sticking
  Real dynamic_friction = static_cast<Real>(.6);  // Coulomb coefficient while sliding, at most the static one
  Real restitution = 0;                           // 0 ... 1
};

struct NamedMaterial {
  std::string_view name;
  Material material;
};

/// The article's table of densities and restitutions: Rock, Wood, Metal, BouncyBall, SuperBall, Pillow, Static.
std::span<const NamedMaterial> materials();

/// Returns the material with this name (as listed, or in lower case with dashes), or null.
const Material* find_material(std::string_view name);

enum class FrictionMixing { geometric, pythagorean, average, min, max, multiply };
enum class RestitutionMixing { max, min, average, multiply };

Real mix(FrictionMixing rule, Real a, Real b);
Real mix(RestitutionMixing rule, Real a, Real b);

}  // namespace impulse::inline IMPULSE_PRECISION
