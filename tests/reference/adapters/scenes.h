#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "reference/simulation.h"

/// Small scenes for the tests of single adapters.
namespace plumb::adapter_tests {

inline Body body_of(BodyType type, Vec position, Geometry geometry, double restitution = 0) {
  Body body;
  body.name = "body";
  body.type = type;
  body.position = position;
  body.shapes.push_back({std::move(geometry), {1, .5, .5, restitution}});
  return body;
}

inline Scene scene_of(std::vector<Body> bodies) {
  Scene scene;
  scene.bodies = std::move(bodies);
  return scene;
}

/// Vertices of a regular polygon with this circumradius, m.
inline std::vector<Vec> regular_polygon(std::size_t count, double radius = 1) {
  std::vector<Vec> vertices(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    vertices[i] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return vertices;
}

/// The state of the last body after so many steps of 1/60 s.
inline BodyState last_state(const Engine& engine, const Scene& scene, const Settings& settings, int steps) {
  const std::unique_ptr<Simulation> simulation = engine.build(scene, settings);
  for (int i = 0; i < steps; ++i) simulation->step(1.0 / 60);
  std::vector<BodyState> states(scene.bodies.size());
  simulation->read(states);
  return states.back();
}

}  // namespace plumb::adapter_tests
