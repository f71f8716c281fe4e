#include "reports/judge/scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../fakes.h"

namespace plumb::scale_test {
namespace {

double scale_of(const Scene& scene, Quantity quantity, double expected, const Truth* truth = nullptr) {
  return Scales(scene, truth).of({.body = scene.bodies[0].name, .quantity = quantity}, expected);
}

Scene resting_box() {
  Scene scene = fakes::thrown_box();
  scene.bodies[0].velocity = {};
  scene.bodies[0].angular_velocity = 0;
  return scene;
}

// Half the diagonal of 1 m x 2 m.
const double size = std::hypot(0.5, 1.0);

TEST(Scales, AreWhatTheExpectedValueSaysChanges) {
  const Scene scene = fakes::thrown_box();
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::x, 7), 6);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::angle, 8.5), 8);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::vy, -12), 12);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::landing, 1.6), 1.6);
}

TEST(Scales, AreTheBodysOwnWhereNothingChanges) {
  const Scene scene = resting_box();
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::x, 1), size);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::angle, 0.5), 1);
  const double falls = std::sqrt(2 * 10 * size);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::vx, 0), falls);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::angular_velocity, 0), falls / size);
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::load, 5), 2 * 10) << "the weight of all bodies";
}

TEST(Scales, CountAsAtRestBelowAHundredthOfTheFloor) {
  const Scene scene = resting_box();
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::x, 1 + 0.0099 * size), size);
  EXPECT_NEAR(scale_of(scene, Quantity::x, 1 + 0.0101 * size), 0.0101 * size, 1e-12);
}

// It rises by 3.2 m and falls by 4 m below its start, however little of that a check at some moment sees.
TEST(Scales, SpanTheWholeMotionOfTheClosedForm) {
  const Scene scene = fakes::thrown_box();
  const Engine closed_form = fakes::free_flight();
  const Truth truth(closed_form, scene);
  EXPECT_NEAR(scale_of(scene, Quantity::y, 2, &truth), std::hypot(6.0, 4.0), 1e-12);
  EXPECT_NEAR(scale_of(scene, Quantity::vx, 3, &truth), std::hypot(3.0, 12.0), 1e-12);
}

TEST(Scales, FollowTheLargestSpeedWithoutGravity) {
  Scene scene = fakes::thrown_box();
  scene.gravity = {};
  EXPECT_DOUBLE_EQ(scale_of(scene, Quantity::speed, 0), std::hypot(3.0, 8.0));
}

}  // namespace
}  // namespace plumb::scale_test
