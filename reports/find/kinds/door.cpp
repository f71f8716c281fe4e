#include <algorithm>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::door {
namespace {

// A door on a hinge swings, driven or not, to its stops or against something.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.chance(0.5) ? Vec{} : draw.gravity(), .duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  const double length = draw.between(0.5, 2);
  scene.bodies.push_back(fixed(disc("post", {}, 0.05, of)));
  Body door = box("door", {length / 2, 0}, {length, draw.between(0.05, 0.3)}, of);
  door.angular_velocity = draw.between(-6, 6);
  // The hinge holds its place: the centre moves at w x r.
  door.velocity = {0, door.angular_velocity * length / 2};
  scene.bodies.push_back(door);
  Revolute hinge{.a = 0, .b = 1, .anchor = {}};
  if (draw.chance(0.6)) hinge.limits = Limits{.low = -draw.between(0, 1.5), .high = draw.between(0, 1.5)};
  scene.joints.push_back(hinge);
  if (draw.chance(0.4)) scene.forces.push_back(Constant{.body = 1, .torque = draw.between(-20, 20)});
  if (draw.chance(0.5)) {
    const double size = draw.between(0.1, 0.4);
    Body other = draw.body("other", {draw.between(0.3, 1) * length, size + 0.3 + draw.between(0, 0.5)}, size);
    other.velocity = {0, -draw.between(0, 4)};
    scene.bodies.push_back(other);
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "door", .about = "A door on a hinge, with stops, a torque or something to hit.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::door
