#pragma once

#include <numbers>
#include <string>
#include <utility>

#include "scenarios/scene.h"

/// Pieces that scenes are put together from.
namespace plumb {

/// A surface with one coefficient of friction for sticking and sliding.
inline Surface surface(double friction, double restitution, double density = 1) {
  return {.density = density, .static_friction = friction, .dynamic_friction = friction, .restitution = restitution};
}

/// Everything below y = 0. A half-space has no corner to meet and no thickness to fall through: the plainest ground
/// there is.
inline Body level_ground(Surface of) {
  return {.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}, .surface = of}}};
}

inline Body box(std::string name, Vec position, Vec size, Surface of) {
  return {.name = std::move(name), .position = position, .shapes = {{.geometry = Box{.size = size}, .surface = of}}};
}

inline Body disc(std::string name, Vec position, double radius, Surface of) {
  return {
      .name = std::move(name), .position = position, .shapes = {{.geometry = Circle{.radius = radius}, .surface = of}}};
}

constexpr double degree = std::numbers::pi / 180;  // rad

}  // namespace plumb
