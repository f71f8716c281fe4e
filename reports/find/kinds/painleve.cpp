#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::painleve {
namespace {

// A rod slides over ground so rough, with its foot in front, that rigidity and Coulomb's friction contradict each other
// (see scenarios/friction/painleve_rod.cpp).
Scene scene(Draw& draw) {
  Scene scene{.duration = 1};
  const Surface rough = surface(draw.between(1.4, 5), 0);
  scene.bodies.push_back(level_ground(rough));
  const Vec size{draw.between(1, 2), 0.02};
  Body rod = box("rod", {0, size.x / 2 + size.y}, size, rough);
  rod.angle = -draw.between(0.7, 1.2);
  rod.velocity = {draw.between(2, 10), -draw.between(0, 2)};
  scene.bodies.push_back(rod);
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "painleve",
                                  .about = "A rod slides over rough ground with its foot in front.",
                                  .posed = Posed::impossible,
                                  .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::painleve
