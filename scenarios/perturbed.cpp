#include "scenarios/perturbed.h"

#include "scenarios/random.h"

namespace plumb {

Scene perturbed(const Scene& scene, double size, std::uint64_t seed) {
  Random random(seed);
  Scene moved = scene;
  for (Body& body : moved.bodies) {
    if (body.type != BodyType::dynamic) continue;
    body.position.x += random.between(-size, size);
    body.position.y += random.between(-size, size);
  }
  return moved;
}

}  // namespace plumb
