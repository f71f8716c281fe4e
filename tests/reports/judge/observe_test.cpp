#include "reports/judge/observe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <tuple>

#include "../fakes.h"

namespace plumb::observe_test {
namespace {

Expectation of_box(Quantity quantity, std::optional<double> time = {}, int index = 0) {
  return {.body = "box", .quantity = quantity, .time = time, .index = index};
}

// Thrown up with 8 m/s from 2 m under 10 m/s^2: highest after 0.8 s, at 2 + 64/20 m.
TEST(Observe, FindsTheApexOfAnArcExactlyWhateverTheStep) {
  const Scene scene = fakes::thrown_box();
  for (const double dt : {0.3, 0.1, 1.0 / 60, 1.0 / 1000}) {
    const auto reading = observe(scene, fakes::flight_of(scene, dt), of_box(Quantity::apex, {}, 1), scene.duration);
    ASSERT_TRUE(reading) << dt;
    EXPECT_NEAR(reading->value, 5.2, 1e-12) << dt;
    // A vertex is flat, so its time is only known to the square root of the rounding.
    EXPECT_NEAR(reading->time, 0.8, 1e-9) << dt;
  }
}

TEST(Observe, CountsApexesAndReturnsNothingForThoseThatNeverCome) {
  const Scene scene = fakes::thrown_box();
  Trace trace(1);
  for (int i = 0; i <= 100; ++i) {
    const BodyState state{.position = {0, std::abs(std::sin(i * 0.1)) * (1 + i * 0.01)}};
    trace.record(i * 0.1, std::span(&state, 1), {});
  }
  const auto second = observe(scene, trace, of_box(Quantity::apex, {}, 2), 10);
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->time, 4.7798, 1e-3);  // where tan t = -(10 + t)
  EXPECT_FALSE(observe(scene, trace, of_box(Quantity::apex, {}, 4), 10));
}

// Lets a body fall and bounce at e = 1 from 1.25 m: at .5 s, 1.5 s and 2.5 s.
Trace bouncing(double dt, double delay = 0) {
  Trace trace(1);
  for (int i = 0; i * dt <= 3; ++i) {
    const double since = i * dt < 0.5 + delay ? i * dt : std::fmod(i * dt - 0.5 - delay, 1) - 0.5;
    const double low = -5 * (0.5 + delay) * (0.5 + delay) + 1.25;  // a late bounce turns the body below the ground
    const BodyState state{
        .position = {0, i * dt < 0.5 + delay ? 1.25 - 5 * since * since : low + 1.25 - 5 * since * since},
        .velocity = {0, -10 * since}};
    trace.record(i * dt, std::span(&state, 1), {});
  }
  return trace;
}

TEST(Observe, FindsLandingsExactlyWhateverTheStep) {
  const Scene scene = fakes::thrown_box();
  for (const double dt : {0.11, 1.0 / 60, 1.0 / 1000}) {
    for (int n = 1; n <= 2; ++n) {
      const auto reading = observe(scene, bouncing(dt), of_box(Quantity::landing, {}, n), 3);
      ASSERT_TRUE(reading) << dt;
      EXPECT_NEAR(reading->value, n - 0.5, 1e-12) << dt;
    }
    EXPECT_FALSE(observe(scene, bouncing(dt), of_box(Quantity::landing, {}, 4), 3));
  }
}

TEST(Observe, FindsALandingThatIsLate) {
  const auto reading = observe(fakes::thrown_box(), bouncing(1.0 / 60, 0.007), of_box(Quantity::landing, {}, 1), 3);
  EXPECT_NEAR(reading->value, 0.507, 1e-12);
}

TEST(Observe, ReadsFreeFlightExactlyBetweenSteps) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.5);
  for (const double t : {0.1, 0.25, 0.4}) {
    EXPECT_NEAR(observe(scene, trace, of_box(Quantity::y, t), scene.duration)->value, 2 + 8 * t - 5 * t * t, 1e-14);
    EXPECT_NEAR(observe(scene, trace, of_box(Quantity::vy, t), scene.duration)->value, 8 - 10 * t, 1e-14);
  }
}

// A body that is halted half a second into a step of one: 1 m at 2 m/s. No cubic strays farther than the two speeds can
// lead in that step.
TEST(Observe, StaysNearTheChordWhereSpeedsJump) {
  const Scene scene = fakes::thrown_box();
  Trace trace(1);
  for (const auto& [time, x, v] : {std::tuple{0.0, 0.0, 2.0}, {1.0, 1.0, 0.0}}) {
    const BodyState state{.position = {x, 0}, .velocity = {v, 0}};
    trace.record(time, std::span(&state, 1), {});
  }
  for (double t = 0; t <= 1; t += 0.125) {
    EXPECT_NEAR(observe(scene, trace, of_box(Quantity::x, t), scene.duration)->value, t, 0.26) << t;
  }
  EXPECT_EQ(observe(scene, trace, of_box(Quantity::x, 1), scene.duration)->value, 1);
}

TEST(Observe, ReadsTheEndIfNoTimeIsGiven) {
  const Scene scene = fakes::thrown_box();
  const auto reading = observe(scene, fakes::flight_of(scene, 1.0 / 60), of_box(Quantity::x), scene.duration);
  EXPECT_DOUBLE_EQ(reading->time, 2);
  EXPECT_NEAR(reading->value, 7, 1e-12);
}

TEST(Observe, ReadsNothingAfterTheEndOfATrace) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.1);
  EXPECT_FALSE(observe(scene, trace, of_box(Quantity::x, 2.5), scene.duration));
}

// Steps of half a second in which a floor and a wall push the only dynamic body with the given impulses.
Trace pushed(const std::vector<double>& floor, double wall) {
  Trace trace(3);
  const std::vector<BodyState> states(3);
  trace.record(0, states, {});
  double time = 0;
  for (const double impulse : floor) {
    const ContactState contacts[] = {{.a = 1, .b = 0, .normal_impulse = impulse},
                                     {.a = 1, .b = 0, .normal_impulse = 1},
                                     {.a = 0, .b = 2, .normal_impulse = wall}};
    trace.record(time += 0.5, states, contacts);
  }
  return trace;
}

TEST(Observe, ComputesALoadFromTheImpulsesOfAStep) {
  const Scene scene{.name = "pushed", .duration = 2, .bodies = {{.name = "box"}, {.name = "floor"}, {.name = "wall"}}};
  const Trace trace = pushed({3, 5, 7, 9}, 4);
  Expectation load = of_box(Quantity::load);
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 2 * (9 + 1 + 4));
  load.other = "floor";
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 2 * (9 + 1));
  load.other = "wall";
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 8);
  load.body = "floor";
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 0);
}

TEST(Observe, AveragesOverTheTimeBeforeAMoment) {
  const Scene scene{.name = "pushed", .duration = 2, .bodies = {{.name = "box"}, {.name = "floor"}, {.name = "wall"}}};
  const Trace trace = pushed({3, 5, 7, 9}, 0);
  Expectation load = of_box(Quantity::load);
  load.over = 1;
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 2 * (8 + 1));
  load.over = 2;  // all steps, but not the start
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 2 * (6 + 1));
  load.over = 0.5;
  EXPECT_DOUBLE_EQ(observe(scene, trace, load, 2)->value, 2 * (9 + 1));
}

TEST(Observe, NeedsContactsForALoad) {
  EXPECT_TRUE(is_reported(pushed({1}, 0), Quantity::load));
  EXPECT_FALSE(is_reported(fakes::flight_of(fakes::thrown_box(), 0.5), Quantity::load));
  EXPECT_TRUE(is_reported(fakes::flight_of(fakes::thrown_box(), 0.5), Quantity::energy));
}

TEST(Observe, FindsTheLargestRiseOfTheEnergyAfterAnyFall) {
  const Scene scene{.name = "line", .gravity = {0, 0}, .bodies = {fakes::thrown_box().bodies[0]}};  // 2 kg
  Trace trace(1);
  const double speeds[] = {3, 1, 2, 1, 2.5};  // m v^2/2 = v^2: 9, 1, 4, 1, 6.25
  for (int i = 0; i < 5; ++i) {
    const BodyState state{.velocity = {speeds[i], 0}};
    trace.record(i, std::span(&state, 1), {});
  }
  const auto reading = observe(scene, trace, {.quantity = Quantity::energy_rise}, 4);
  EXPECT_DOUBLE_EQ(reading->value, 5.25);
  EXPECT_EQ(reading->time, 4);
  EXPECT_DOUBLE_EQ(observe(scene, trace, {.quantity = Quantity::energy_rise, .time = 3}, 4)->value, 3);
}

TEST(Observe, MeasuresTheSpreadOfSpeedsInAnyDirections) {
  Scene scene{.name = "two", .bodies = {fakes::thrown_box().bodies[0], fakes::thrown_box().bodies[0]}};
  Trace trace(2);
  const BodyState states[] = {{.velocity = {3, 4}}, {.velocity = {0, -5}}};
  trace.record(0, states, {});
  const BodyState later[] = {{.velocity = {0, 0}}, {.velocity = {0, -5}}};
  trace.record(1, later, {});
  EXPECT_DOUBLE_EQ(observe(scene, trace, {.quantity = Quantity::speed_spread, .time = 0}, 1)->value, 1);
  EXPECT_DOUBLE_EQ(observe(scene, trace, {.quantity = Quantity::speed_spread}, 1)->value, 2);
}

TEST(Observe, SuggestsTheBodyThatWasMeant) {
  const Scene scene = fakes::thrown_box();
  try {
    index_of(scene, "bax");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "thrown: unknown body \"bax\", did you mean \"box\"?");
  }
}

}  // namespace
}  // namespace plumb::observe_test
