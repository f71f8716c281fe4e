#include "reference/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenarios/parts.h"
#include "scenarios/scene/path.h"

namespace plumb::paths_test {
namespace {

// A table on a path, and a ball far from it.
Scene scene() {
  Body table = box("table", {1, 2}, {2, 1}, {});
  table.type = BodyType::kinematic;
  table.velocity = {0.5, 0};
  table.path = Path{.amplitude = {0.1, 0.3}, .frequency = 0.8, .phase = 0.4};
  return {.name = "path", .bodies = {table, disc("ball", {50, 0}, 0.5, {})}};
}

TEST(Path, BeginsWhereTheBodyIsAndHasTheDerivativeThatItStates) {
  const Path path = *scene().bodies[0].path;
  EXPECT_EQ(path_offset(path, 0), Vec{});
  constexpr double h = 1e-6;
  const Vec start = start_velocity(scene().bodies[0]);
  EXPECT_NEAR(start.x, 0.5 + path_offset(path, h).x / h, 1e-5);
  EXPECT_NEAR(start.y, path_offset(path, h).y / h, 1e-5);
  EXPECT_NEAR(path_offset(path, 1 / 0.8).y, 0, 1e-15) << "after a period";
}

TEST(Paths, TakeABodyOfEveryEngineExactlyWhereTheyLead) {
  const Scene on_path = scene();
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (engine->exact || !engine->unsupported(on_path, complete(*engine, {})).empty()) continue;
    const auto simulation = engine->build(on_path, complete(*engine, {}));
    const double epsilon = engine->stepping(complete(*engine, {}), 1.0 / 60).epsilon;
    std::vector<BodyState> states(2);
    simulation->read(states);
    EXPECT_NEAR(states[0].velocity.y, start_velocity(on_path.bodies[0]).y, 1e-6) << engine->name;
    double t = 0;
    for (int i = 0; i < 100; ++i) {
      const double dt = i % 2 == 0 ? 1.0 / 60 : 1.0 / 100;
      simulation->step(dt);
      t += dt;
      simulation->read(states);
      const Vec offset = path_offset(*on_path.bodies[0].path, t);
      EXPECT_NEAR(states[0].position.x, 1 + 0.5 * t + offset.x, 8 * (i + 1) * epsilon + 1e-12) << engine->name;
      EXPECT_NEAR(states[0].position.y, 2 + offset.y, 8 * (i + 1) * epsilon + 1e-12) << engine->name;
    }
  }
}

TEST(Paths, LeaveOtherScenesAlone) {
  Scene plain = scene();
  plain.bodies[0].path.reset();
  const Engine& engine = *Catalog<Engine>::find("impulse");
  auto simulation = engine.build(plain, complete(engine, {}));
  const Simulation* made = simulation.get();
  EXPECT_EQ(on_paths(plain, std::move(simulation)).get(), made);
}

}  // namespace
}  // namespace plumb::paths_test
