#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "scenarios/scene/scene.h"

/// Bodies that many scenes are built from.
namespace plumb {

/// A fixed half-space. It has no corners to hit and no thickness to fall through.
inline Body half_space(std::string name, HalfSpace solid, Surface of) {
  return {.name = std::move(name), .type = BodyType::fixed, .shapes = {{.geometry = solid, .surface = of}}};
}

/// The half-space y <= 0, "ground".
inline Body level_ground(Surface of) { return half_space("ground", {}, of); }

inline Body box(std::string name, Vec position, Vec size, Surface of) {
  return {.name = std::move(name), .position = position, .shapes = {{.geometry = Box{.size = size}, .surface = of}}};
}

inline Body disc(std::string name, Vec position, double radius, Surface of) {
  return {
      .name = std::move(name), .position = position, .shapes = {{.geometry = Circle{.radius = radius}, .surface = of}}};
}

inline Body fixed(Body body) {
  body.type = BodyType::fixed;
  return body;
}

/// A floor at y = 0 and walls at x = -width/2 and width/2, all half-spaces, so that nothing can get through them.
inline Body pit(double width, Surface of) {
  Body made = half_space("pit", {}, of);
  made.shapes.push_back({.geometry = HalfSpace{.normal = {1, 0}, .offset = -width / 2}, .surface = of});
  made.shapes.push_back({.geometry = HalfSpace{.normal = {-1, 0}, .offset = -width / 2}, .surface = of});
  return made;
}

/// s, no shorter, and a whole number of steps at 60 a second.
inline double whole_steps(double time) { return std::ceil(60 * time) / 60; }

constexpr double degree = std::numbers::pi / 180;  // rad

}  // namespace plumb
