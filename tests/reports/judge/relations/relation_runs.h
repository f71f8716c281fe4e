#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "../../fakes.h"
#include "reports/run/relations.h"
#include "reports/run/selection.h"

/// Engines that keep the relations and engines that break one of them, on scenes that anyone can follow.
namespace plumb::relation_tests {

/// The default engine with a mistake: the scene is changed before it is built, as a solver that knew too much would.
inline Engine with_mistake(const std::function<void(Scene&)>& mistake) {
  const Engine& right = *Catalog<Engine>::find("impulse");
  Engine wrong = right;
  wrong.name = "wrong";
  wrong.build = [&right, mistake](const Scene& scene, const Settings& settings) {
    // The simulation may refer to the scene that it was built from.
    struct Changed : Simulation {
      Scene scene;
      std::unique_ptr<Simulation> inner;
      void step(double dt) override { inner->step(dt); }
      void read(std::span<BodyState> out) const override { inner->read(out); }
      void read_contacts(std::vector<ContactState>& contacts) const override { inner->read_contacts(contacts); }
    };
    auto changed = std::make_unique<Changed>();
    changed->scene = scene;
    mistake(changed->scene);
    changed->inner = right.build(changed->scene, settings);
    return changed;
  };
  return wrong;
}

inline RelationCheck checked(const std::string& relation, const Scene& scene, const EngineConfig& config,
                             double dt = 1.0 / 60) {
  const Outcome outcome = run(scene, config, dt);
  return check_relations(scene, config, dt, *outcome.trace, {relation}).front();
}

/// By our engine.
inline RelationCheck ours(const std::string& relation, const Scene& scene) {
  return checked(relation, scene, parse_engine("impulse"));
}

/// By our engine with a mistake.
inline RelationCheck mistaken(const std::string& relation, const Scene& scene,
                              const std::function<void(Scene&)>& mistake) {
  const Engine wrong = with_mistake(mistake);
  return checked(relation, scene, {&wrong, complete(wrong, {})});
}

/// A box that slides and a disc that falls beside it, on the ground, 1 s.
inline Scene box_and_disc() {
  const Surface rough = surface(0.3, 0);
  return {.name = "box and disc",
          .duration = 1,
          .bodies = {{.name = "ground", .type = BodyType::fixed, .shapes = {{HalfSpace{}, rough}}},
                     {.name = "box", .position = {0, 0.5}, .velocity = {2, 0}, .shapes = {{Box{}, rough}}},
                     {.name = "disc",
                      .position = {5, 2.3},
                      .velocity = {-0.4, 0},
                      .shapes = {{Circle{.radius = 0.4}, surface(0.3, 0.5)}}}}};
}

/// A box and a disc that fly, and the rod between them.
inline Scene flying_rod() {
  return {.name = "flying rod",
          .duration = 1,
          .bodies = {{.name = "box", .position = {0, 0.5}, .velocity = {2, 5}, .shapes = {{Box{}, surface(0, 1)}}},
                     {.name = "disc",
                      .position = {3, 1},
                      .velocity = {1, 7},
                      .shapes = {{Circle{.radius = 0.4}, surface(0, 1)}}}},
          .joints = {Distance{.a = 0, .b = 1, .anchor_a = {0, 0.5}, .anchor_b = {3, 1}, .length = 3.0413812651491097}}};
}

}  // namespace plumb::relation_tests
