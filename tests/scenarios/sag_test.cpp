#include "scenarios/sag.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/mass.h"

namespace plumb::sag_test {
namespace {

constexpr double frequency = 60;  // Hz
constexpr double omega = 2 * std::numbers::pi * frequency;
constexpr double g = 10;  // m/s^2

Scene scene_of(const char* name, const Parameters& changes = {}) {
  const Scenario& family = *Catalog<Scenario>::find(name);
  return family.scene(complete(family, changes));
}

// The hinge k from the top carries 11 - k links, between two of them or, the first, between one and what is fixed.
TEST(SagOf, LengthensAHangingChainByTheWeightBelowEachHinge) {
  const Scene scene = scene_of("chain-row");
  double weights = 10;
  for (int below = 9; below >= 1; --below) weights += 2 * below;
  const Vec last = sag_of(scene, frequency).back().shift;
  EXPECT_NEAR(last.y, -weights * g / (omega * omega), 1e-12);
  EXPECT_NEAR(last.x, 0, 1e-12);
}

// The weld of one segment takes its weight at the end, 1/m + r^2/I, and its torque, 1/I.
TEST(SagOf, BendsABeamByTheTorqueOnItsWeld) {
  const Scene scene = scene_of("cantilever");
  const Mass segment = mass_of(scene.bodies[1]);
  const Sag tip = sag_of(scene, frequency)[1];
  const double turn = segment.mass * g * 0.5 / segment.inertia / (omega * omega);
  const double shift = g * (1 + segment.mass * 0.5 * 0.5 / segment.inertia) / (omega * omega);
  EXPECT_NEAR(tip.turn, -turn, 1e-12);
  EXPECT_NEAR(tip.shift.y, -shift - 0.5 * turn, 1e-12);
}

// The same equations solved by Gaussian elimination, in another language. The mirror image sags alike.
TEST(SagOf, HangsANetEvenlyFromItsTwoCorners) {
  const std::vector<Sag> sags = sag_of(scene_of("joint-grid"), frequency);
  EXPECT_EQ(sags[0].shift, Vec{});
  for (std::size_t column = 0; column < 7; ++column) {
    EXPECT_NEAR(sags[42 + column].shift.y, sags[48 - column].shift.y, 1e-12);
  }
  EXPECT_NEAR(sags[45].shift.y, -0.00927741, 1e-8) << "in the middle of the lowest row";
}

TEST(SagOf, FallsWithTheSquareOfTheFrequency) {
  const Scene scene = scene_of("hanging-chain");
  EXPECT_NEAR(sag_of(scene, 30).back().shift.y, 4 * sag_of(scene, 60).back().shift.y, 1e-10);
}

TEST(SagOf, IsNoneWithoutSprings) {
  const Scene scene = scene_of("chain-row");
  EXPECT_EQ(sag({}, scene, 5), 0);
  EXPECT_EQ(sag_angle({}, scene, 5), 0);
}

}  // namespace
}  // namespace plumb::sag_test
