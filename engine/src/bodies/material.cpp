#include "impulse/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

NamedMaterial listed(std::string_view name, double density, double restitution) {
  Material material;
  material.density = static_cast<Real>(density);
  material.restitution = static_cast<Real>(restitution);
  return {name, material};
}

// "BouncyBall" becomes "bouncy-ball".
std::string dashed(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool capital = 'A' <= c && c <= 'Z';
    if (capital && !out.empty()) out += '-';
    out += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

}  // namespace

std::span<const NamedMaterial> materials() {
  static const std::array list{
      listed("Rock", 0.6, 0.1),       listed("Wood", 0.3, 0.2),       listed("Metal", 1.2, 0.05),
      listed("BouncyBall", 0.3, 0.8), listed("SuperBall", 0.3, 0.95), listed("Pillow", 0.1, 0.2),
      listed("Static", 0.0, 0.4),
  };
  return list;
}

const Material* find_material(std::string_view name) {
  for (const NamedMaterial& entry : materials()) {
    if (entry.name == name || dashed(entry.name) == name) return &entry.material;
  }
  return nullptr;
}

Real mix(FrictionMixing rule, Real a, Real b) {
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

Real mix(RestitutionMixing rule, Real a, Real b) {
  switch (rule) {
    case RestitutionMixing::max:
      return std::max(a, b);
    case RestitutionMixing::min:
      return std::min(a, b);
    case RestitutionMixing::average:
      return (a + b) / 2;
    case RestitutionMixing::multiply:
      return a * b;
  }
  return 0;
}

}  // namespace impulse::inline IMPULSE_PRECISION
