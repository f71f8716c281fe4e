#include <gtest/gtest.h>

#include "../../fakes.h"
#include "measuring.h"

namespace plumb {
namespace {

Scene on_ground() {
  return {.bodies = {{.name = "context", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}},
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

TEST(TimeToRest, IsNothingForWhatStillMoves) {
  const Scene scene = on_ground();
  const Trace trace = speeds({0, 0, 0.02});
  EXPECT_FALSE(measured("time_to_rest", {.scene = scene, .trace = trace}));
}

TEST(ResidualSpeed, IsTheRmsOverTheLastTenth) {
  const Scene scene = on_ground();
  const Trace trace = speeds({9, 9, 9, 9, 9, 9, 9, 9, 9, 3, 4});
  EXPECT_DOUBLE_EQ(*measured("residual_speed", {.scene = scene, .trace = trace}), std::sqrt((9 + 16) / 2.0));
}

}  // namespace
}  // namespace plumb
