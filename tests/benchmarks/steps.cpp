// What a step costs: our solvers in float beside every rival, all through their adapters, one thread. Every run starts
// from the same scene and makes the same number of steps, so that moving piles are compared over the same seconds.

#include <benchmark/benchmark.h>

#include <random>
#include <stdexcept>

#include "reference/simulation.h"

namespace plumb {
namespace {

constexpr double dt = 1.0 / 60;

Body body(BodyType type, Vec position, Geometry geometry) {
  Body made;
  made.type = type;
  made.position = position;
  made.shapes.push_back({std::move(geometry), {1, .6, .6, 0}});
  return made;
}

Scene pyramid(int base) {
  Scene scene;
  scene.bodies.push_back(body(BodyType::fixed, {0, -1}, Box{{400, 2}}));
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      scene.bodies.push_back(body(BodyType::dynamic, {1.05 * (i + .5 * row - .5 * base), row + .5}, Box{}));
    }
  }
  return scene;
}

Scene free_bodies() {
  Scene scene;
  for (int i = 0; i < 10000; ++i) {
    Body made = body(BodyType::dynamic, {3.0 * (i % 100), 3.0 * (i / 100)}, Box{});
    made.angular_velocity = .1 * (i % 7);
    scene.bodies.push_back(made);
  }
  return scene;
}

/// Into a trough; places and sizes from one seed.
Scene rain() {
  Scene scene;
  scene.bodies.push_back(body(BodyType::fixed, {0, -1}, Box{{80, 2}}));
  scene.bodies.push_back(body(BodyType::fixed, {-31, 50}, Box{{2, 100}}));
  scene.bodies.push_back(body(BodyType::fixed, {31, 50}, Box{{2, 100}}));
  std::mt19937 random(1);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int i = 0; i < 2000; ++i) {
    const double size = between(.6, 1);
    const Vec at{-28.5 + 1.5 * (i % 39), 2 + 1.5 * (i / 39)};
    scene.bodies.push_back(i % 2 == 0 ? body(BodyType::dynamic, at, Circle{size / 2})
                                      : body(BodyType::dynamic, at, Box{{size, size}}));
    scene.bodies.back().angle = between(-1, 1);
    scene.bodies.back().velocity = {between(-1, 1), between(-1, 0)};
  }
  return scene;
}

/// Balls and boxes that go on bouncing in a pen: 600 of them, e = 0.8, without friction.
Scene bouncing() {
  Scene scene;
  scene.bodies.push_back(body(BodyType::fixed, {0, -1}, Box{{40, 2}}));
  scene.bodies.push_back(body(BodyType::fixed, {-13, 50}, Box{{2, 100}}));
  scene.bodies.push_back(body(BodyType::fixed, {13, 50}, Box{{2, 100}}));
  std::mt19937 random(2);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int i = 0; i < 600; ++i) {
    const Vec at{-11 + .95 * (i % 24), 1 + .95 * (i / 24)};
    scene.bodies.push_back(body(BodyType::dynamic, at, i % 2 == 0 ? Geometry{Circle{.4}} : Geometry{Box{{.7, .7}}}));
    scene.bodies.back().shapes[0].surface = {1, 0, 0, .8};
    scene.bodies.back().angle = between(-1, 1);
    scene.bodies.back().velocity = {between(-5, 5), between(-5, 5)};
  }
  return scene;
}

void run(benchmark::State& state, const Contender& contender, const Settings& settings, const Scene& scene,
         int warm_up) {
  const std::unique_ptr<Simulation> simulation = contender.build(scene, settings);
  try {
    for (int i = 0; i < warm_up; ++i) simulation->step(dt);
    for ([[maybe_unused]] auto step : state) simulation->step(dt);
  } catch (const std::domain_error& beyond) {
    state.SkipWithError(beyond.what());
  }
}

struct Case {
  std::string name;
  Scene scene;
  int warm_up, steps;
};

void enter(const Case& one, const std::string& name, const Contender& contender, const Settings& settings) {
  benchmark::RegisterBenchmark(
      (one.name + "/" + name).c_str(),
      [one, &contender, settings](benchmark::State& state) { run(state, contender, settings, one.scene, one.warm_up); })
      ->Iterations(one.steps)
      ->Unit(benchmark::kMicrosecond);
}

void enter_all() {
  for (const Case& one : {Case{"pyramid-100", pyramid(100), 60, 60}, Case{"pyramid-20", pyramid(20), 60, 600},
                          Case{"free-10000", free_bodies(), 10, 200}, Case{"rain-2000", rain(), 0, 600},
                          Case{"bouncing-600", bouncing(), 0, 600}}) {
    for (const Contender* contender : Catalog<Contender>::all()) {
      if (contender->exact) continue;
      if (contender->name != "impulse") {
        enter(one, contender->name, *contender, {});
        continue;
      }
      for (const Option& option : contender->options) {
        if (option.key != "solver") continue;
        for (const auto& [solver, about] : option.choices) {
          enter(one, solver, *contender, {{"solver", solver}, {"precision", "float"}});
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::enter_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
