#include <fmt/format.h>

#include <algorithm>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::jointed {
namespace {

// Bodies joined into trees hit the ground and each other.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  scene.bodies.push_back(level_ground(draw.surface()));
  const int count = draw.count(2, 16);
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.1, 0.5);
    Body body = draw.body(fmt::format("body {}", i + 1), {draw.between(-2, 2), size + draw.between(0.01, 2)}, size);
    if (!add_apart(scene, body)) continue;
    ++i;
    const std::size_t b = scene.bodies.size() - 1;
    if (b < 2 || draw.chance(0.25)) continue;
    const auto a = static_cast<std::size_t>(draw.whole(1, static_cast<int>(b) - 1));
    const Vec from = scene.bodies[a].position;
    const Vec middle = 0.5 * (from + body.position);
    switch (draw.whole(0, 3)) {
      case 0:
        scene.joints.push_back(Weld{.a = a, .b = b, .anchor = middle});
        break;
      case 1:
        scene.joints.push_back(Distance{
            .a = a, .b = b, .anchor_a = from, .anchor_b = body.position, .length = length(body.position - from)});
        break;
      case 2:
        scene.joints.push_back(Prismatic{.a = a, .b = b, .anchor = middle, .axis = draw.direction()});
        break;
      default:
        scene.joints.push_back(Revolute{.a = a, .b = b, .anchor = middle});
    }
  }
  if (draw.chance(0.5)) {
    const Vec common = draw.within(2, 2);
    for (Body& body : scene.bodies) {
      if (body.type == BodyType::dynamic) body.velocity = common;
    }
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "jointed", .about = "Joined bodies hit the ground and each other.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::jointed
