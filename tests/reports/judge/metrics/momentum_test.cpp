#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb {
namespace {

TEST(MomentumError, IsNothingInFreeFlight) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 1.0 / 60);
  const MetricContext context{.scene = scene, .trace = trace};
  EXPECT_NEAR(*measured("momentum_error", context), 0, 1e-12);
  EXPECT_NEAR(*measured("angular_momentum_error", context), 0, 1e-11);
}

TEST(MomentumError, FindsAPushThatNobodyGave) {
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

TEST(MomentumError, SaysNothingWhereThereIsSomethingToMeet) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back({.name = "context", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}});
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
}  // namespace plumb
