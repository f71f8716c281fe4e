// Scenes without a pile: the fixed cost of a step, and the cost of a body that touches nothing.

#include <utility>

#include "../benchmark_scene.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks::no_pile {
namespace {

SceneSetup on_the_ground(std::vector<Body> bodies) {
  SceneSetup setup{.size = 1, .reach = 10};
  setup.scene.bodies = std::move(bodies);
  setup.scene.bodies.push_back(fixed(box("ground", {0, -1}, {40, 2}, surface(0.6, 0))));
  return setup;
}

SceneSetup one_box() { return on_the_ground({box("box", {0, 0.5}, {1, 1}, surface(0.6, 0))}); }

SceneSetup three_bodies() {
  return on_the_ground({box("box", {0, 0.5}, {1, 1}, surface(0.6, 0)), disc("disc", {3, 0.5}, 0.5, surface(0.6, 0))});
}

SceneSetup free_bodies() {
  SceneSetup setup{.size = 1};
  for (int i = 0; i < 10000; ++i) {
    Body body = box("box", {3.0 * (i % 100), 3.0 * (i / 100)}, {1, 1}, surface(0.6, 0));
    body.angular_velocity = 0.1 * (i % 7);
    setup.scene.bodies.push_back(body);
  }
  return setup;
}

const Catalog<BenchmarkScene>::Entry one{{.name = "one-box",
                                          .about = "a box that rests on the ground",
                                          .settled = {200, 10200},
                                          .moving = {},
                                          .setup = one_box}};

const Catalog<BenchmarkScene>::Entry three{{.name = "three-bodies",
                                            .about = "a box and a disc that rest on the ground",
                                            .settled = {200, 10200},
                                            .moving = {},
                                            .setup = three_bodies}};

const Catalog<BenchmarkScene>::Entry free{{.name = "free-10000",
                                           .about = "10 000 boxes that fall and never meet",
                                           .settled = {},
                                           .moving = {10, 210},
                                           .setup = free_bodies}};

}  // namespace
}  // namespace plumb::benchmarks::no_pile
