#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb {
namespace {

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

TEST(LateralDrift, IsMeasuredAcrossGravityAtTheEnd) {
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
}  // namespace plumb
