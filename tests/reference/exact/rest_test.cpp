#include "reference/exact/rest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "scenarios/parts.h"

namespace plumb {
namespace {

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

TEST(Rest, EachContactCarriesWhatIsAboveIt) {
  const std::vector<ContactState> contacts = loads(tower({0, 0, 0}));
  ASSERT_EQ(contacts.size(), 6u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double above = 20.0 * static_cast<double>(3 - k);  // m g = 2 * 10
    EXPECT_DOUBLE_EQ(contacts[2 * k].normal_impulse + contacts[2 * k + 1].normal_impulse, above);
    EXPECT_DOUBLE_EQ(contacts[2 * k].normal_impulse, contacts[2 * k + 1].normal_impulse);
    EXPECT_EQ(contacts[2 * k].b, k + 1);
  }
}

// Forces and moments on every body must balance, whatever the tower.
TEST(Rest, BalancesForcesAndMomentsOnEveryBody) {
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

TEST(Rest, RefusesWhatTopples) {
  EXPECT_THAT(rest().unsupported(tower({0, 1.01}), {}), testing::HasSubstr("topples"));
  EXPECT_EQ(rest().unsupported(tower({0, 0.99}), {}), "");
}

TEST(Rest, RefusesWhatMovesOrFloats) {
  Scene moving = tower({0});
  moving.bodies[1].velocity.x = 1;
  EXPECT_NE(rest().unsupported(moving, {}), "");
  Scene floating = tower({0});
  floating.bodies[1].position.y += 1e-3;
  EXPECT_NE(rest().unsupported(floating, {}), "");
}

}  // namespace
}  // namespace plumb
