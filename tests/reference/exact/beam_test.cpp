#include "reference/exact/beam.h"

#include <gtest/gtest.h>

#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

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

TEST(Beam, ScalesWithItsWeightAloneWhateverTheLengthsAreMeasuredIn) {
  EXPECT_DOUBLE_EQ(Beam(30, 1, 3).left(), Beam(30, 100, 300).left());
  EXPECT_DOUBLE_EQ(Beam(60, 1, 3).left(), 2 * Beam(30, 1, 3).left());
}

TEST(BeamScene, GivesTheImpulsesOfAStepToTheSupports) {
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

}  // namespace
}  // namespace plumb
