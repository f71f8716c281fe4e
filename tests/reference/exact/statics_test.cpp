#include "reference/exact/statics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::statics_test {
namespace {

namespace beam_tests {

TEST(Beam, BalancesForcesAndMoments) {
  for (const double a : {0.1, 1.0, 7.0}) {
    const Beam beam(30, a, 2);
    EXPECT_NEAR(beam.left() + beam.right(), 30, 1e-14);
    EXPECT_NEAR(beam.left() * a, beam.right() * 2, 1e-13);
  }
}

TEST(Beam, HasAllItsWeightOnASupportBelowItsCentre) {
  EXPECT_NEAR(Beam(30, 1e-12, 2).left(), 30, 1e-10);
  EXPECT_NEAR(Beam(30, 1e-12, 2).right(), 0, 1e-10);
}

TEST(Beam, ScalesWithItsWeightAndNotWithItsLength) {
  EXPECT_DOUBLE_EQ(Beam(30, 1, 3).left(), Beam(30, 100, 300).left());
  EXPECT_DOUBLE_EQ(Beam(60, 1, 3).left(), 2 * Beam(30, 1, 3).left());
}

TEST(BeamScene, ReportsTheImpulsesOfAStepOnTheSupports) {
  const Scenario& family = *Catalog<Scenario>::find("beam");
  const Scene scene = family.scene(complete(family, {}));
  const auto simulation = Catalog<Engine>::find("beam")->build(scene, {});
  simulation->step(0.5);
  std::vector<ContactState> contacts;
  simulation->read_contacts(contacts);
  ASSERT_EQ(contacts.size(), 2u);
  const double weight = mass_of(scene.bodies[2]).mass * 10;
  EXPECT_DOUBLE_EQ(contacts[0].normal_impulse, weight * 0.75 * 0.5);
  EXPECT_DOUBLE_EQ(contacts[1].normal_impulse, weight * 0.25 * 0.5);
  EXPECT_EQ(contacts[0].a, 0u);
  EXPECT_EQ(contacts[1].a, 1u);
}

TEST(BeamScene, IsRefusedWithItsCentreBeyondASupport) {
  const Scenario& family = *Catalog<Scenario>::find("beam");
  Scene scene = family.scene(complete(family, {}));
  scene.bodies[0].position.x = 1;
  EXPECT_NE(Catalog<Engine>::find("beam")->unsupported(scene, {}), "");
}

}  // namespace beam_tests

namespace rest_tests {

Scene tower(const std::vector<double>& middles) {
  Scene scene{.name = "tower"};
  scene.bodies.push_back(level_ground(surface(0.5, 0)));
  double bottom = 0;
  for (const double x : middles) {
    scene.bodies.push_back(box("box", {x, bottom + 0.5}, {2, 1}, surface(0.5, 0)));
    bottom += 1;
  }
  return scene;
}

const Engine& rest() { return *Catalog<Engine>::find("rest"); }

std::vector<ContactState> loads(const Scene& scene) {
  const std::unique_ptr<Simulation> simulation = rest().build(scene, {});
  std::vector<ContactState> contacts;
  simulation->step(1);
  simulation->read_contacts(contacts);
  return contacts;
}

TEST(RestingTower, EachContactCarriesTheWeightAboveIt) {
  const std::vector<ContactState> contacts = loads(tower({0, 0, 0}));
  ASSERT_EQ(contacts.size(), 6u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double above = 20.0 * static_cast<double>(3 - k);  // m g = 2 * 10
    EXPECT_DOUBLE_EQ(contacts[2 * k].normal_impulse + contacts[2 * k + 1].normal_impulse, above);
    EXPECT_DOUBLE_EQ(contacts[2 * k].normal_impulse, contacts[2 * k + 1].normal_impulse);
    EXPECT_EQ(contacts[2 * k].b, k + 1);
  }
}

// In any tower the forces and moments on every body balance.
TEST(RestingTower, BalancesForcesAndMomentsOnEveryBody) {
  const Scene scene = tower({0, 0.3, 0.1, 0.6});
  const std::vector<ContactState> contacts = loads(scene);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    double force = -20;
    double moment = 0;
    for (const ContactState& contact : contacts) {
      const double sign = contact.b == i ? 1 : contact.a == i ? -1 : 0;
      force += sign * contact.normal_impulse;
      moment += sign * contact.normal_impulse * (contact.point.x - scene.bodies[i].position.x);
    }
    EXPECT_NEAR(force, 0, 1e-12);
    EXPECT_NEAR(moment, 0, 1e-12);
  }
  for (const ContactState& contact : contacts) EXPECT_GE(contact.normal_impulse, 0);
}

TEST(RestingTower, RefusesATowerThatTopples) {
  EXPECT_THAT(rest().unsupported(tower({0, 1.01}), {}), testing::HasSubstr("topples"));
  EXPECT_EQ(rest().unsupported(tower({0, 0.99}), {}), "");
}

TEST(RestingTower, RefusesATowerThatMovesOrFloats) {
  Scene moving = tower({0});
  moving.bodies[1].velocity.x = 1;
  EXPECT_NE(rest().unsupported(moving, {}), "");
  Scene floating = tower({0});
  floating.bodies[1].position.y += 1e-3;
  EXPECT_NE(rest().unsupported(floating, {}), "");
  Scene rising = tower({0});
  rising.bodies[1].gravity_scale = -0.5;
  EXPECT_NE(rest().unsupported(rising, {}), "");
}

TEST(RestingTower, RefusesBoxesThatPassThroughEachOther) {
  Scene falling = tower({0});
  falling.bodies[1].layers = 1;
  EXPECT_EQ(rest().unsupported(falling, {}), "");
  falling.bodies.back().layers = 2;
  falling.bodies.front().layers = 1;
  EXPECT_NE(rest().unsupported(falling, {}), "");
}

}  // namespace rest_tests

}  // namespace
}  // namespace plumb::statics_test
