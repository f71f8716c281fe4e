#include "reports/find/kind.h"

#include <fmt/format.h>

#include "reports/system/hash.h"

namespace plumb {
namespace {

std::uint64_t seed_of(const Kind& kind, std::uint64_t seed, int n) {
  BitHash hash;
  hash.add(seed);
  hash.add(static_cast<std::uint64_t>(n));
  for (const char letter : kind.name) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  return hash.value();
}

// Rare features of bodies, so that each meets every kind.
void season(Draw& draw, Scene& scene) {
  const bool in_layers = draw.chance(0.1);
  for (Body& body : scene.bodies) {
    if (in_layers && body.type == BodyType::dynamic && body.layers == Body{}.layers) {
      body.layers = static_cast<std::uint32_t>(draw.whole(1, 7));  // some meet, some pass; all meet what is fixed
    }
  }
  if (!draw.chance(0.2)) return;
  for (Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic || !draw.chance(0.3)) continue;
    if (draw.chance(0.4)) body.linear_damping = draw.between(0, 2);
    if (draw.chance(0.3)) body.angular_damping = draw.between(0, 2);
    if (draw.chance(0.2)) body.gravity_scale = draw.between(-0.5, 2);
    if (body.angular_velocity == 0 && draw.chance(0.2)) body.fixed_rotation = true;
  }
}

}  // namespace

Scene drawn(const Kind& kind, std::uint64_t seed, int n) {
  Draw draw(seed_of(kind, seed, n));
  Scene scene = kind.scene(draw);
  season(draw, scene);
  scene.name = fmt::format("{}/{}", kind.name, n);
  scene.about = fmt::format("{} Drawn from seed {}.", kind.about, seed);
  return scene;
}

}  // namespace plumb
