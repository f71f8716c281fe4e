#include "scenarios/images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>
#include <vector>

#include "reference/simulation.h"
#include "reports/judge/mechanics.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::images_test {
namespace {

// Of every kind of shape, joint and force.
Scene of_everything() {
  const Surface material = surface(0.3, 0.2, 2);
  Scene scene{.name = "everything",
              .bodies = {{.name = "ground",
                          .type = BodyType::fixed,
                          .shapes = {{HalfSpace{{0, 1}, 0.25}, material}, {Segment{{1, 2}, {3, 4}}, material}}},
                         {.name = "a",
                          .position = {1, 2},
                          .angle = 0.25,
                          .velocity = {3, 4},
                          .angular_velocity = 2,
                          .shapes = {{Box{{1, 2}, {0.5, 0.25}, 0.5}, material}, {Circle{0.5, {0.5, 0}}, material}}},
                         {.name = "b",
                          .position = {4, 2},
                          .velocity = {-1, 0.5},
                          .linear_damping = 0.5,
                          .shapes = {{Polygon{{{0, 0}, {1, 0}, {0, 1}}}, material},
                                     {Capsule{{0, 0}, {1, 0.5}, 0.25}, material}}}},
              .joints = {Revolute{1, 2, {2, 3}, Limits{-0.5, 1}, Motor{2, 3}},
                         Prismatic{0, 1, {1, 1}, {1, 0.5}, Limits{-1, 2}, Motor{4, 5}}, Weld{1, 2, {3, 3}},
                         Distance{.a = 0, .b = 2, .anchor_a = {0, 1}, .anchor_b = {1, 1}, .length = 2, .stiffness = 8}},
              .forces = {Spring{.a = {}, .b = 1, .anchor_a = {1, 5}, .anchor_b = {0.5, 0}, .stiffness = 4, .length = 1},
                         Constant{2, {1, 2}, 3}, Attraction{.from = 1, .strength = 2, .exponent = 2}}};
  return scene;
}

std::string text_of(const Scene& scene) { return write_scene({.scene = scene, .truth = {}}); }

TEST(Images, MirroredTwiceIsTheScene) {
  const Congruence mirror{.mirrored = true};
  const Scene scene = of_everything();
  EXPECT_NE(text_of(mapped(scene, mirror)), text_of(scene));
  EXPECT_EQ(text_of(mapped(mapped(scene, mirror), mirror)), text_of(scene));
}

TEST(Images, ListedBackwardsTwiceIsTheScene) {
  const Scene scene = of_everything();
  EXPECT_NE(text_of(listed_backwards(scene)), text_of(scene));
  EXPECT_EQ(text_of(listed_backwards(listed_backwards(scene))), text_of(scene));
}

TEST(Congruence, IsUndoneByItsInverse) {
  for (const bool mirrored : {false, true}) {
    const Congruence map{.mirrored = mirrored, .angle = 0.7, .shift = {3, -2}};
    const Vec point = map.inverse().of_point(map.of_point({5, 7}));
    EXPECT_NEAR(point.x, 5, 1e-14);
    EXPECT_NEAR(point.y, 7, 1e-14);
    EXPECT_NEAR(map.inverse().of_angle(map.of_angle(0.4)), 0.4, 1e-15);
  }
}

// Of all terms, springs and constant forces too, but those whose zero the image moves.
double kinetic(const Scene& scene) { return Conserved(scene).energy(initial_states(scene)).kinetic(); }

TEST(Images, KeepTheKineticEnergy) {
  const Scene scene = of_everything();
  EXPECT_NEAR(kinetic(mapped(scene, {.mirrored = true, .angle = 0.7, .shift = {9, 1}})), kinetic(scene), 1e-12);
  EXPECT_NEAR(kinetic(listed_backwards(scene)), kinetic(scene), 1e-12);
  EXPECT_NEAR(kinetic(doubled(scene, {50, 0}, 0xFFFF, 16)), 2 * kinetic(scene), 1e-12);
  EXPECT_NEAR(kinetic(in_units(scene, {.mass = 10})), 10 * kinetic(scene), 1e-11);
}

// Joules are kg m^2/s^2: M L^2/(sqrt L)^2; forces are M, for gravity is the same.
TEST(Images, InOtherUnitsScaleEveryForceAndEnergy) {
  Scene scene = of_everything();
  scene.forces.pop_back();  // the centre of an attraction is measured from where it is
  const double length = 4;
  const double mass = 10;
  const Scene image = in_units(scene, {.length = length, .mass = mass, .time = std::sqrt(length)});
  const Conserved here(scene);
  const Conserved there(image);
  EXPECT_NEAR(there.energy(initial_states(image)).total(), mass * length * here.energy(initial_states(scene)).total(),
              1e-9);
  const auto forces = AppliedForces(scene).at(initial_states(scene));
  const auto scaled_forces = AppliedForces(image).at(initial_states(image));
  for (std::size_t i = 0; i < forces.size(); ++i) {
    EXPECT_NEAR(scaled_forces[i].force.x, mass * forces[i].force.x, 1e-9);
    EXPECT_NEAR(scaled_forces[i].force.y, mass * forces[i].force.y, 1e-9);
    EXPECT_NEAR(scaled_forces[i].torque, mass * length * forces[i].torque, 1e-9);
  }
}

TEST(Images, OfAnAttractionScaleLikeGravity) {
  Scene scene = of_everything();
  scene.forces.erase(scene.forces.begin(), scene.forces.end() - 1);
  const auto pull = [](const Scene& of) { return AppliedForces(of).at(initial_states(of))[2].force; };
  EXPECT_NEAR(pull(in_units(scene, {.length = 4, .mass = 10, .time = 2})).x, 10 * pull(scene).x, 1e-12);
  EXPECT_NEAR(pull(in_units(scene, {.mass = 10})).x, 10 * pull(scene).x, 1e-12);
}

TEST(Images, OfForcesTurnWithTheScene) {
  const Scene scene = of_everything();
  const Congruence map{.mirrored = true, .angle = 0.7, .shift = {9, 1}};
  const Scene image = mapped(scene, map);
  const auto forces = AppliedForces(scene).at(initial_states(scene));
  const auto turned = AppliedForces(image).at(initial_states(image));
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const Vec expected = map.of_vector(forces[i].force);
    EXPECT_NEAR(turned[i].force.x, expected.x, 1e-12);
    EXPECT_NEAR(turned[i].force.y, expected.y, 1e-12);
    EXPECT_NEAR(turned[i].torque, -forces[i].torque, 1e-12);
  }
}

TEST(Images, BoostedMoveAllAlike) {
  const Scene scene = of_everything();
  const Scene image = boosted(scene, {5, -1});
  EXPECT_EQ(image.bodies[0].type, BodyType::kinematic);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    EXPECT_EQ(image.bodies[i].velocity.x, scene.bodies[i].velocity.x + 5);
    EXPECT_EQ(image.bodies[i].velocity.y, scene.bodies[i].velocity.y - 1);
  }
}

TEST(Images, TakeBodiesAlongTheImagesOfTheirPaths) {
  const Scene scene{.bodies = {{.name = "lift",
                                .type = BodyType::kinematic,
                                .position = {1, 2},
                                .velocity = {0.5, 0},
                                .path = Path{.amplitude = {0.1, 0.3}, .frequency = 0.8, .phase = 0.4}}}};
  const auto place = [](const Scene& of, double t) {
    const Body& body = of.bodies[0];
    const Vec offset = path_offset(*body.path, t);
    return Vec{body.position.x + t * body.velocity.x + offset.x, body.position.y + t * body.velocity.y + offset.y};
  };
  constexpr double t = 0.7;
  const Vec there = place(scene, t);
  const auto expect_at = [&](Vec expected, const Scene& image, double time) {
    EXPECT_NEAR(place(image, time).x, expected.x, 1e-14);
    EXPECT_NEAR(place(image, time).y, expected.y, 1e-14);
  };
  const Congruence map{.mirrored = true, .angle = 0.7, .shift = {9, 1}};
  expect_at(map.of_point(there), mapped(scene, map), t);
  expect_at({4 * there.x, 4 * there.y}, in_units(scene, {.length = 4, .mass = 10, .time = 2}), 2 * t);
  expect_at({3 * there.x, 3 * there.y}, in_units(scene, {.length = 3}), t);
  expect_at({there.x + 5 * t, there.y - t}, boosted(scene, {5, -1}), t);
}

TEST(Images, OfTwoWorldsShareNoLayer) {
  const Scene scene = of_everything();
  const Scene both = doubled(scene, {50, 0}, 0xFFFF, 16);
  ASSERT_EQ(both.bodies.size(), 6u);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 3; k < 6; ++k) EXPECT_EQ(both.bodies[i].layers & both.bodies[k].layers, 0u);
    EXPECT_NE(both.bodies[3].layers & both.bodies[3 + i].layers, 0u);
  }
  EXPECT_EQ(std::get<Constant>(both.forces[4]).body, 5u);
}

std::vector<BodyState> end_of(const Scene& scene) {
  const Engine& engine = *Catalog<Engine>::find("impulse");
  const auto simulation = engine.build(scene, complete(engine, {}));
  for (int i = 0; i < 60; ++i) simulation->step(1.0 / 60);
  std::vector<BodyState> states(scene.bodies.size());
  simulation->read(states);
  return states;
}

Scene default_scene(const Scenario& scenario) { return scenario.scene(complete(scenario, {})); }

TEST(Images, WithLongerLengthsKeepMassesAndScaleInertiaWithTheSquare) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    const Scene scene = default_scene(*scenario);
    const Scene larger = in_units(scene, {.length = 4});
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      EXPECT_DOUBLE_EQ(mass_of(larger.bodies[i]).mass, mass_of(scene.bodies[i]).mass) << scenario->name;
      EXPECT_DOUBLE_EQ(mass_of(larger.bodies[i]).inertia, 16 * mass_of(scene.bodies[i]).inertia) << scenario->name;
    }
  }
}

// Free motion, joints and forces have no length scale of their own.
TEST(Images, WithLongerLengthsMoveInProportion) {
  Scene pushed = default_scene(*Catalog<Scenario>::find("spinning-obb"));
  pushed.bodies = {pushed.bodies.back()};
  pushed.forces = {Constant{.body = 0, .force = {3, 1}, .torque = 0.5}};
  std::vector<Scene> scenes{pushed};
  for (const char* name : {"spring", "orbit", "pendulum", "double-pendulum", "heavy-object"}) {
    scenes.push_back(default_scene(*Catalog<Scenario>::find(name)));
  }
  for (const Scene& scene : scenes) {
    const auto original = end_of(scene);
    const auto larger = end_of(in_units(scene, {.length = 4}));
    for (std::size_t i = 0; i < original.size(); ++i) {
      EXPECT_NEAR(larger[i].position.x, 4 * original[i].position.x, 1e-11) << scene.name;
      EXPECT_NEAR(larger[i].position.y, 4 * original[i].position.y, 1e-11) << scene.name;
      EXPECT_NEAR(larger[i].angle, original[i].angle, 1e-11) << scene.name;
    }
  }
}

TEST(Perturbed, MovesOnlyDynamicBodiesByAtMostTheSize) {
  const Scene scene = default_scene(*Catalog<Scenario>::find("stacking"));
  const Scene moved = perturbed(scene, 0.01, 1);
  EXPECT_EQ(moved.bodies[0].position, scene.bodies[0].position);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    EXPECT_NE(moved.bodies[i].position, scene.bodies[i].position);
    EXPECT_NEAR(moved.bodies[i].position.x, scene.bodies[i].position.x, 0.01);
    EXPECT_NEAR(moved.bodies[i].position.y, scene.bodies[i].position.y, 0.01);
  }
}

TEST(Perturbed, IsTheSameForTheSameSeed) {
  const Scene scene = default_scene(*Catalog<Scenario>::find("stacking"));
  EXPECT_EQ(perturbed(scene, 0.01, 1).bodies[1].position, perturbed(scene, 0.01, 1).bodies[1].position);
  EXPECT_NE(perturbed(scene, 0.01, 2).bodies[1].position, perturbed(scene, 0.01, 1).bodies[1].position);
}

}  // namespace
}  // namespace plumb::images_test
