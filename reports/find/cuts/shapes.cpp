#include <algorithm>
#include <limits>
#include <variant>

#include "reports/find/shrink.h"
#include "scenarios/catalog.h"

namespace plumb::cuts::shapes {
namespace {

// Simpler shapes inside the given one, about as large: inside, so that nothing starts in something else.
std::vector<Geometry> inside(const Geometry& geometry) {
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return {Circle{.radius = std::min(box->size.x, box->size.y) / 2, .center = box->center}};
  }
  if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
    const Vec middle{(capsule->from.x + capsule->to.x) / 2, (capsule->from.y + capsule->to.y) / 2};
    return {Circle{.radius = capsule->radius, .center = middle}};
  }
  if (const auto* polygon = std::get_if<Polygon>(&geometry)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec corner : polygon->vertices) {
      least = std::min({least, std::max(std::abs(corner.x), std::abs(corner.y))});
    }
    std::vector<Geometry> all{Circle{.radius = least * 0.7, .center = {}}};
    if (polygon->vertices.size() > 3) {
      Polygon triangle{.vertices = {polygon->vertices.begin(), polygon->vertices.begin() + 3}};
      all.push_back(Box{.size = {least, least}, .center = {}, .angle = 0});
      all.push_back(triangle);
    }
    return all;
  }
  return {};
}

std::vector<Scene> simpler_shapes(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t k = 0; k < scene.bodies[i].shapes.size(); ++k) {
      for (const Geometry& simpler : inside(scene.bodies[i].shapes[k].geometry)) {
        all.push_back(scene);
        all.back().bodies[i].shapes[k].geometry = simpler;
      }
    }
  }
  return all;
}

const Catalog<Cut>::Entry entry{{.name = "simpler shapes", .order = 6, .simpler = simpler_shapes}};

}  // namespace
}  // namespace plumb::cuts::shapes
