#include "reports/find/shrink.h"
#include "scenarios/catalog.h"

namespace plumb::cuts::bodies {
namespace {

// Without the second half of the bodies, the first, the last quarter, ... each single one, last first: what stands on
// others is dropped before what it stands on.
std::vector<Scene> fewer_bodies(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  const std::size_t count = scene.bodies.size();
  if (count < 2) return all;
  for (std::size_t size = (count + 1) / 2;; size = (size + 1) / 2) {
    for (std::size_t end = count; end > 0; end -= std::min(size, end)) {
      const std::size_t begin = end - std::min(size, end);
      if (end - begin < count) all.push_back(without_bodies(scene, begin, end));
    }
    if (size == 1) return all;
  }
}

// With one moving body held in place.
std::vector<Scene> frozen(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  for (std::size_t i = scene.bodies.size(); i-- > 0;) {
    if (scene.bodies[i].type == BodyType::fixed) continue;
    Scene simpler = scene;
    Body& body = simpler.bodies[i];
    body.type = BodyType::fixed;
    body.velocity = {};
    body.angular_velocity = 0;
    all.push_back(std::move(simpler));
  }
  return all;
}

// Without one of a body's shapes.
std::vector<Scene> fewer_shapes(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t k = scene.bodies[i].shapes.size(); k-- > 0 && scene.bodies[i].shapes.size() > 1;) {
      Scene simpler = scene;
      auto& shapes = simpler.bodies[i].shapes;
      shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(k));
      all.push_back(std::move(simpler));
    }
  }
  return all;
}

const Catalog<Cut>::Entry drop{{.name = "drop bodies", .order = 1, .simpler = fewer_bodies}};
const Catalog<Cut>::Entry freeze{{.name = "freeze bodies", .order = 4, .simpler = frozen}};
const Catalog<Cut>::Entry shapes{{.name = "drop shapes", .order = 3, .simpler = fewer_shapes}};

}  // namespace
}  // namespace plumb::cuts::bodies
