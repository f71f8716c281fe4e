#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::chain {
namespace {

// Links from a hook, straight in any direction; with two hooks a bridge that hangs in an arc (a straight one between
// rigid hooks needs an infinite force to bend, and no law says what it does); with a ground something to hit.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  const int links = draw.count(1, 30);
  const bool bridge = draw.chance(0.35) && links > 1;
  const bool rods = draw.chance(0.3);
  const double length = draw.between(0.2, 1);
  const double sag = bridge ? draw.between(0.2, 1) : 0;  // rad, of the first link below the horizontal
  const Vec straight = bridge ? Vec{} : draw.direction();
  const Surface of = draw.surface();
  const auto hook = [&](const char* name, Vec at) {
    scene.bodies.push_back(fixed(disc(name, at, 0.05, of)));
    return scene.bodies.size() - 1;
  };
  std::size_t before = hook("hook", {});
  Vec joint;
  Vec centre;
  for (int i = 0; i < links; ++i) {
    const double slope = bridge ? sag * (2.0 * i / (links - 1) - 1) : 0;
    const Vec along = bridge ? rotated({1, 0}, slope) : straight;
    const Vec last_centre = centre;
    centre = joint + 0.5 * length * along;
    Body link = box(fmt::format("link {}", i + 1), centre, {0.8 * length, 0.2 * length}, of);
    if (bridge) {
      link.angle = slope;
    } else {
      link = disc(link.name, link.position, 0.3 * length, of);
    }
    if (i == links - 1 && draw.chance(0.3)) link.shapes[0].surface.density *= draw.over_magnitudes(0.1, 20);
    scene.bodies.push_back(link);
    const std::size_t last = scene.bodies.size() - 1;
    if (rods) {
      const Vec from = i == 0 ? joint : last_centre;
      const double span = plumb::length(centre - from);
      scene.joints.push_back(
          Distance{.a = before, .b = last, .anchor_a = from, .anchor_b = link.position, .length = span});
    } else {
      scene.joints.push_back(Revolute{.a = before, .b = last, .anchor = joint});
    }
    before = last;
    joint = joint + length * along;
  }
  if (bridge && !rods) scene.joints.push_back(Revolute{.a = before, .b = hook("other hook", joint), .anchor = joint});
  if (draw.chance(0.3)) {
    scene.bodies.push_back(half_space("ground", {.offset = -(links + 1) * length}, of));
  }
  if (bridge && draw.chance(0.5)) {
    scene.bodies.push_back(draw.body("load", {draw.between(0, joint.x), 0.6}, 0.3));
  }
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "chain", .about = "A chain or a bridge hangs.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::chain
