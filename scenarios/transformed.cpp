#include "scenarios/transformed.h"

#include "scenarios/random.h"
#include "scenarios/scene/forces.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/path.h"
#include "scenarios/scene/shapes.h"

namespace plumb {

Scene scaled(const Scene& scene, double factor) {
  Scene larger = scene;
  larger.gravity = scaled(scene.gravity, factor);
  for (Body& body : larger.bodies) {
    body.position = scaled(body.position, factor);
    body.velocity = scaled(body.velocity, factor);
    if (body.path) body.path = scaled(*body.path, factor);
    for (Shape& shape : body.shapes) {
      shape.geometry = scaled(shape.geometry, factor);
      shape.surface.density /= factor * factor;
    }
  }
  for (Joint& joint : larger.joints) joint = scaled(joint, factor);
  for (Force& force : larger.forces) force = scaled(force, factor);
  return larger;
}

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
