#include "scenarios/joints/linked.h"

#include <cmath>
#include <string>

#include "scenarios/parts.h"

namespace plumb {

void add_links(Scene& scene, std::span<const Vec> points, double thickness) {
  scene.bodies.push_back({.name = "hook", .type = BodyType::fixed, .position = points[0], .layers = 0});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec from = points[i - 1];
    const Vec to = points[i];
    const double straight = (std::hypot(to.x - from.x, to.y - from.y) - thickness) / 2;
    scene.bodies.push_back(
        {.name = "link " + std::to_string(i),
         .position = {(from.x + to.x) / 2, (from.y + to.y) / 2},
         .angle = std::atan2(to.y - from.y, to.x - from.x),
         .layers = 0,
         .shapes = {{.geometry = Capsule{{-straight, 0}, {straight, 0}, thickness / 2}, .surface = surface(0.5, 0)}}});
    const std::size_t link = scene.bodies.size() - 1;
    scene.joints.push_back(Revolute{.a = link - 1, .b = link, .anchor = from});
  }
}

}  // namespace plumb
