#include "reports/judge/states.h"

#include <gtest/gtest.h>

namespace plumb::states_test {
namespace {

Scene two_bodies() { return {.bodies = {{.name = "free"}, {.name = "wheel", .type = BodyType::kinematic}}}; }

Scene above_ground() {
  Scene scene = two_bodies();
  scene.bodies[1] = {.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}};
  return scene;
}

Trace trace_of(std::initializer_list<double> speeds) {
  Trace trace(2);
  for (const double speed : speeds) {
    const BodyState states[] = {{.velocity = {0, speed}}, {.velocity = {9, 0}, .angular_velocity = 9}};
    trace.record(static_cast<double>(trace.size()), states, {});
  }
  return trace;
}

TEST(TimeToRest, IsWhenTheLastDynamicBodyStopsForGood) {
  EXPECT_EQ(time_to_rest(above_ground(), trace_of({1, 0, 1, 0.009, 0})), 3);
  EXPECT_EQ(time_to_rest(above_ground(), trace_of({0, 0})), 0);
}

TEST(TimeToRest, IsMissingIfABodyMovesAtTheEnd) {
  EXPECT_EQ(time_to_rest(above_ground(), trace_of({0, 0, 0.011})), std::nullopt);
}

TEST(TimeToRest, IsMissingWhereNothingIsThereToRestOn) {
  EXPECT_EQ(time_to_rest(two_bodies(), trace_of({0, 0})), std::nullopt);
}

TEST(FastestSpeed, IsThatOfTheDynamicBodies) {
  const Trace trace = trace_of({3});
  EXPECT_EQ(fastest_speed(two_bodies(), trace.states(0)), 3);
}

}  // namespace
}  // namespace plumb::states_test
