#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb::conservation_test {
namespace {

// After 2 s: v = (3, -12), y = 2 + 16 - 20.
TEST(EnergyAtTheEnd, IsSplitIntoItsKinds) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 1.0 / 60);
  const MetricContext context{.scene = scene, .trace = trace};
  EXPECT_NEAR(*measured("kinetic_energy_end", context), 9 + 144, 1e-9);
  EXPECT_NEAR(*measured("rotational_energy_end", context), 2 * (1 + 4) / 12.0 * 16 / 2, 1e-9);
  EXPECT_NEAR(*measured("potential_energy_end", context), 2 * 10 * -2, 1e-9);
}

// 2 kg without gravity at the given speeds: E = v^2.
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

TEST(EnergyRise, DoesNotApplyWithWorkFromOutside) {
  Scene scene = sliding_box(4);
  const Trace trace = speeds({4, 5});
  scene.forces = {Constant{.body = 0, .force = {1, 0}}};
  EXPECT_FALSE(measured("energy_rise", {.scene = scene, .trace = trace}));
  scene.forces.clear();
  scene.bodies.push_back({.name = "belt", .type = BodyType::kinematic, .velocity = {1, 0}});
  EXPECT_FALSE(measured("energy_drift", {.scene = scene, .trace = trace}));
}

TEST(MomentumError, IsZeroInFreeFlight) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 1.0 / 60);
  const MetricContext context{.scene = scene, .trace = trace};
  EXPECT_NEAR(*measured("momentum_error", context), 0, 1e-12);
  EXPECT_NEAR(*measured("angular_momentum_error", context), 0, 1e-11);
}

TEST(MomentumError, FindsAnUnexplainedImpulse) {
  const Scene scene = fakes::thrown_box();
  Trace trace(1);
  BodyState state = initial_states(scene)[0];
  trace.record(0, std::span(&state, 1), {});
  state.velocity = state.velocity + Vec{0.5, 0};
  state.position.y = 0;
  trace.record(1e-9, std::span(&state, 1), {});
  const MetricContext context{.scene = scene, .trace = trace};
  EXPECT_NEAR(*measured("momentum_error", context), 1, 1e-7);
  // From y = 2 to 0: -y p_x goes from -2 * 6 to 0.
  EXPECT_NEAR(*measured("angular_momentum_error", context), 12, 1e-6);
}

TEST(MomentumError, DoesNotApplyWithABodyToCollideWith) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back({.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}});
  const Trace trace = fakes::flight_of(scene, 0.1);
  EXPECT_FALSE(measured("momentum_error", {.scene = scene, .trace = trace}));
  EXPECT_FALSE(measured("angular_momentum_error", {.scene = scene, .trace = trace}));
}

TEST(AngularMomentumError, NeedsOneGravityScale) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].gravity_scale = 2;
  const Trace trace = fakes::flight_of(scene, 0.1);
  EXPECT_NEAR(*measured("momentum_error", {.scene = scene, .trace = trace}), 0, 1e-12);
  EXPECT_FALSE(measured("angular_momentum_error", {.scene = scene, .trace = trace}));
}

}  // namespace
}  // namespace plumb::conservation_test
