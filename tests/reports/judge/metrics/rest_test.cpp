#include <gtest/gtest.h>

#include <cmath>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb::rest_test {
namespace {

Scene on_ground() {
  return {.bodies = {{.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}},
                     {.name = "box", .shapes = {{.geometry = Box{}}}}}};
}

Trace speeds(std::initializer_list<double> values) {
  Trace trace(2);
  for (const double speed : values) {
    const BodyState states[] = {{}, {.velocity = {0, speed}}};
    trace.record(static_cast<double>(trace.size()), states, {});
  }
  return trace;
}

TEST(TimeToRest, CountsFromTheLastMotion) {
  const Scene scene = on_ground();
  const Trace trace = speeds({1, 0, 0.02, 0.005, 0});
  EXPECT_EQ(measured("time_to_rest", {.scene = scene, .trace = trace}), 3);
}

TEST(TimeToRest, IsMissingIfABodyStillMoves) {
  const Scene scene = on_ground();
  const Trace trace = speeds({0, 0, 0.02});
  EXPECT_FALSE(measured("time_to_rest", {.scene = scene, .trace = trace}));
}

TEST(ResidualSpeed, IsTheRmsOverTheLastTenth) {
  const Scene scene = on_ground();
  const Trace trace = speeds({9, 9, 9, 9, 9, 9, 9, 9, 9, 3, 4});
  EXPECT_DOUBLE_EQ(*measured("residual_speed", {.scene = scene, .trace = trace}), std::sqrt((9 + 16) / 2.0));
}

TEST(Penetration, IsTheDeepestEverAndAtTheEnd) {
  const Scene scene{.bodies = {{.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}},
                               {.name = "box", .shapes = {{.geometry = Box{}}}}}};
  Trace trace(2);
  for (const double y : {1.0, 0.4, 0.48}) {
    const BodyState states[] = {{}, {.position = {0, y}}};
    trace.record(static_cast<double>(trace.size()), states, {});
  }
  EXPECT_NEAR(*measured("penetration_max", {.scene = scene, .trace = trace}), 0.1, 1e-14);
  EXPECT_NEAR(*measured("penetration_end", {.scene = scene, .trace = trace}), 0.02, 1e-14);
}

Scene resting(Vec gravity) {
  return {.gravity = gravity, .bodies = {{.name = "box", .shapes = {{.geometry = Box{}}}}}};
}

std::optional<double> drift(const Scene& scene) {
  Trace trace(1);
  for (const Vec position : {Vec{1, 1}, Vec{9, 9}, Vec{0.5, -2}}) {
    const BodyState state{.position = position};
    trace.record(static_cast<double>(trace.size()), std::span(&state, 1), {});
  }
  return measured("lateral_drift", {.scene = scene, .trace = trace});
}

TEST(LateralDrift, IsMeasuredPerpendicularToGravityAtTheEnd) {
  EXPECT_DOUBLE_EQ(*drift(resting({0, -10})), 0.5);
  EXPECT_DOUBLE_EQ(*drift(resting({3, 0})), 3);
}

TEST(LateralDrift, NeedsGravityAndAStartAtRest) {
  EXPECT_FALSE(drift(resting({0, 0})));
  Scene moving = resting({0, -10});
  moving.bodies[0].velocity = {0, 1};
  EXPECT_FALSE(drift(moving));
}

}  // namespace
}  // namespace plumb::rest_test
