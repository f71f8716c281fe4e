#include <fmt/format.h>

#include "reports/find/kind.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::chain {
namespace {

// Links from a hook, straight in any direction; with two hooks a bridge, with a ground something to hit.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  const int links = draw.count(1, 30);
  const bool bridge = draw.chance(0.35);
  const bool rods = draw.chance(0.3);
  const double length = draw.between(0.2, 1);
  const Vec along = bridge ? Vec{1, 0} : draw.direction();
  const Surface of = draw.surface();
  const auto hook = [&](const char* name, Vec at) {
    scene.bodies.push_back(fixed(disc(name, at, 0.05, of)));
    return scene.bodies.size() - 1;
  };
  std::size_t before = hook("hook", {});
  for (int i = 0; i < links; ++i) {
    const Vec joint = length * i * along;
    Body link = box(fmt::format("link {}", i + 1), joint + 0.5 * length * along, {0.8 * length, 0.2 * length}, of);
    if (along.x != 1) link = disc(link.name, link.position, 0.3 * length, of);
    if (i == links - 1 && draw.chance(0.3)) link.shapes[0].surface.density *= draw.over_magnitudes(0.1, 20);
    scene.bodies.push_back(link);
    const std::size_t last = scene.bodies.size() - 1;
    if (rods) {
      const Vec from = i == 0 ? joint : joint - 0.5 * length * along;
      const double span = i == 0 ? 0.5 * length : length;
      scene.joints.push_back(
          Distance{.a = before, .b = last, .anchor_a = from, .anchor_b = link.position, .length = span});
    } else {
      scene.joints.push_back(Revolute{.a = before, .b = last, .anchor = joint});
    }
    before = last;
  }
  if (bridge && !rods) {
    scene.joints.push_back(
        Revolute{.a = before, .b = hook("other hook", length * links * along), .anchor = length * links * along});
  }
  if (draw.chance(0.3)) {
    scene.bodies.push_back(half_space("ground", {.offset = -(links + 1) * length}, of));
  }
  if (bridge && draw.chance(0.5)) {
    scene.bodies.push_back(draw.body("load", {draw.between(0, links * length), 0.6}, 0.3));
  }
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "chain", .about = "A chain or a bridge hangs.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::chain
