#include <fmt/format.h>

#include <algorithm>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

// Bodies that joints hold together.
namespace plumb::kinds::joined {
namespace {

// Links from a hook, straight in any direction; with two hooks a bridge that hangs in an arc (a straight one between
// rigid hooks needs an infinite force to bend, and no law says what it does); with a ground something to hit.
Scene chain(Draw& draw) {
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

// In some scenes: drives the first joint, and shakes the post that it starts from.
template <class Tie>
void drive(Draw& draw, double speed, double strength, Scene& scene) {
  auto& joint = std::get<Tie>(scene.joints.front());
  if (draw.chance(0.3)) {
    joint.motor =
        Motor{.speed = draw.between(-speed, speed), .strength = draw.over_magnitudes(strength / 100, strength)};
  }
  if (draw.chance(0.15)) {
    Body& post = scene.bodies[joint.a];
    post.type = BodyType::kinematic;
    post.path = draw.path();
  }
}

Scene door(Draw& draw) {
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
  drive<Revolute>(draw, 6, 100, scene);
  return scene;
}

// On a rail, with or without ends, and a spring, or welded or hung to a second one.
Scene slider(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 2)};
  const Surface of = draw.surface();
  const Vec axis = draw.chance(0.5) ? Vec{1, 0} : draw.direction();
  scene.bodies.push_back(fixed(disc("post", {}, 0.05, of)));
  Body cart = draw.body("cart", 1.2 * axis, draw.between(0.15, 0.5));
  cart.velocity = draw.between(-3, 3) * axis;
  scene.bodies.push_back(cart);
  scene.joints.push_back(Prismatic{.a = 0, .b = 1, .anchor = cart.position, .axis = axis});
  if (draw.chance(0.7)) {
    // Soft enough to be resolved: w dt = sqrt(k/m) / 60 well below 1 for the lightest cart, of a few hundred grams.
    // Hooked beside the rail: the force of a spring with a length jumps where the cart passes its end.
    const double beside = (draw.chance(0.5) ? 1 : -1) * draw.between(0.3, 0.6);
    scene.forces.push_back(Spring{.b = 1,
                                  .anchor_a = draw.between(-1, 1) * axis + beside * Vec{-axis.y, axis.x},
                                  .stiffness = draw.over_magnitudes(1, 50),
                                  .length = draw.between(0, 1),
                                  .damping = draw.chance(0.5) ? 0 : draw.between(0, 1)});
  }
  if (draw.chance(0.5)) {
    const Vec at = cart.position + draw.within(0.3, 0.3) + Vec{0, axis.y > 0 ? 1.2 : -1.2};  // away from the post
    scene.bodies.push_back(draw.body("second", at, draw.between(0.1, 0.4)));
    scene.bodies.back().velocity = cart.velocity;  // what is joined moves together
    if (draw.chance(0.4)) {
      scene.joints.push_back(Weld{.a = 1, .b = 2, .anchor = cart.position});
    } else {
      scene.joints.push_back(
          Distance{.a = 1, .b = 2, .anchor_a = cart.position, .anchor_b = at, .length = length(at - cart.position)});
    }
  }
  if (draw.chance(0.3)) {
    double low = 0;  // m, of what starts above it, none of which reaches farther than half a metre
    for (const Body& body : scene.bodies) low = std::min(low, body.position.y - 0.5);
    scene.bodies.push_back(half_space("ground", {.offset = low - draw.between(0.01, 1.5)}, of));
  }
  if (draw.chance(0.4)) {
    std::get<Prismatic>(scene.joints.front()).limits =
        Limits{.low = -draw.between(0.05, 1), .high = draw.between(0.05, 1)};
  }
  drive<Prismatic>(draw, 3, 100, scene);
  return scene;
}

// Trees of bodies.
Scene jointed(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  scene.bodies.push_back(level_ground(draw.surface()));
  scatter(scene, draw.count(2, 16), [&](std::string name) {
    const double size = draw.over_magnitudes(0.1, 0.5);
    const Vec at{draw.between(-2, 2), size + draw.between(0.01, 2)};
    return draw.body(std::move(name), at, size);
  });
  for (std::size_t b = 2; b < scene.bodies.size(); ++b) {
    if (draw.chance(0.25)) continue;
    const auto a = static_cast<std::size_t>(draw.whole(1, static_cast<int>(b) - 1));
    const Vec from = scene.bodies[a].position;
    const Vec to = scene.bodies[b].position;
    const Vec middle = 0.5 * (from + to);
    switch (draw.whole(0, 3)) {
      case 0:
        scene.joints.push_back(Weld{.a = a, .b = b, .anchor = middle});
        break;
      case 1:
        scene.joints.push_back(Distance{.a = a, .b = b, .anchor_a = from, .anchor_b = to, .length = length(to - from)});
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

const Catalog<Kind>::Entry of_chain{{.name = "chain", .about = "A chain or a bridge hangs.", .scene = chain}};
const Catalog<Kind>::Entry of_door{
    {.name = "door",
     .about = "A door on a hinge swings, driven or not, to its stops or against something.",
     .scene = door}};
const Catalog<Kind>::Entry of_slider{
    {.name = "slider", .about = "A body on a rail, with a motor, a spring or a second body.", .scene = slider}};
const Catalog<Kind>::Entry of_jointed{
    {.name = "jointed", .about = "Joined bodies hit the ground and each other.", .scene = jointed}};

}  // namespace
}  // namespace plumb::kinds::joined
