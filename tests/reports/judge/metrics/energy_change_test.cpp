#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"
#include "reports/judge/energy_range.h"

namespace plumb {
namespace {

// 2 kg without gravity, whose speed goes through the given values: E = v^2.
Trace speeds(std::initializer_list<double> values) {
  Trace trace(1);
  for (const double speed : values) {
    const BodyState state{.velocity = {speed, 0}};
    trace.record(static_cast<double>(trace.size()), std::span(&state, 1), {});
  }
  return trace;
}

Scene sliding_box(double speed) {
  Scene scene = fakes::thrown_box();
  scene.gravity = {0, 0};
  scene.bodies[0].velocity = {speed, 0};
  scene.bodies[0].angular_velocity = 0;
  return scene;
}

TEST(EnergyRise, IsTheLargestClimbFromAnEarlierValue) {
  const Scene scene = sliding_box(4);
  const Trace trace = speeds({4, 2, 3, 1, 2, 0});  // E = 16 4 9 1 4 0: climbs of 5 and 3
  EXPECT_DOUBLE_EQ(*measured("energy_rise", {.scene = scene, .trace = trace}), 5 / 16.0);
  EXPECT_DOUBLE_EQ(*measured("energy_drift", {.scene = scene, .trace = trace}), -1);
}

TEST(EnergyRise, IsZeroInFreeFlight) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 1.0 / 60);
  EXPECT_NEAR(*measured("energy_rise", {.scene = scene, .trace = trace}), 0, 1e-13);
}

TEST(EnergyRise, SaysNothingWhereWorkIsDoneFromOutside) {
  Scene scene = sliding_box(4);
  const Trace trace = speeds({4, 5});
  scene.forces = {Constant{.body = 0, .force = {1, 0}}};
  EXPECT_FALSE(measured("energy_rise", {.scene = scene, .trace = trace}));
  scene.forces.clear();
  scene.bodies.push_back({.name = "belt", .type = BodyType::kinematic, .velocity = {1, 0}});
  EXPECT_FALSE(measured("energy_drift", {.scene = scene, .trace = trace}));
}

// Two boxes of 1 kg, one on the other: 2 m from top to bottom, 20 N of weight.
TEST(EnergyRange, OfAStackIsWhatItsFallWouldSetFree) {
  const Body box{.position = {0, 0.5}, .shapes = {{.geometry = Box{.size = {1, 1}}}}};
  Scene scene{.bodies = {box, box}};
  scene.bodies[1].position = {0, 1.5};
  EXPECT_DOUBLE_EQ(energy_range(scene, nullptr), 40);
}

TEST(EnergyRange, KnowsFromTheClosedFormHowFastItGets) {
  Scene scene = fakes::thrown_box();
  scene.bodies[0].velocity = {0, 0};
  scene.bodies[0].angular_velocity = 0;
  const Trace truth = fakes::flight_of(scene, 0.1);
  EXPECT_NEAR(energy_range(scene, &truth), 2 * 20 * 20 / 2.0, 1e-9);
}

}  // namespace
}  // namespace plumb
