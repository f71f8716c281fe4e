#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::slider {
namespace {

// A body on a rail, with or without ends, and a spring, or welded or hung to a second one.
Scene scene(Draw& draw) {
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
  if (draw.chance(0.3)) scene.bodies.push_back(half_space("ground", {.offset = -draw.between(2.5, 4)}, of));
  if (draw.chance(0.4)) {
    std::get<Prismatic>(scene.joints.front()).limits =
        Limits{.low = -draw.between(0.05, 1), .high = draw.between(0.05, 1)};
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "slider", .about = "A body on a rail, with a spring or a second body.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::slider
