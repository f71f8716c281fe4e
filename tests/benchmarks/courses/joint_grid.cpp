// Box2D 3's benchmark "joint_grid": a net of discs, each hinged to its neighbours half-way, that hangs from seven of
// them in the middle of its upper edge. They collide with nothing. (There the seven are hinged to each other, too,
// which holds nothing and which not every engine can solve.)

#include <cstdlib>

#include "../course.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

constexpr int side = 100;

Start joint_grid() {
  Start start{.size = 0.8};
  std::vector<Body>& bodies = start.scene.bodies;
  for (int column = 0; column < side; ++column) {
    for (int row = 0; row < side; ++row) {
      const std::size_t here = bodies.size();
      const double x = column;
      const double y = -row;
      Body knot = disc("knot", {x, y}, 0.4, surface(0.6, 0));
      knot.layers = 0;
      const bool held = row == 0 && std::abs(column - side / 2) <= 3;
      bodies.push_back(held ? fixed(knot) : knot);
      if (row > 0) start.scene.joints.push_back(Revolute{.a = here - 1, .b = here, .anchor = {x, y + 0.5}});
      const bool between_held = held && bodies[here - side].type == BodyType::fixed;
      if (column > 0 && !between_held)
        start.scene.joints.push_back(Revolute{.a = here - side, .b = here, .anchor = {x - 0.5, y}});
    }
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "joint-grid",
                                    .about = "10 000 discs hinged to their neighbours",
                                    .settled = {},
                                    .moving = {60, 120},
                                    .start = joint_grid}};

}  // namespace
}  // namespace plumb::benchmarks
