#include "reports/observe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/reports/fakes.h"

namespace plumb {
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
    EXPECT_NEAR(reading->time, 0.8, 1e-9)
        << dt;  // a vertex is flat: its time is known to sqrt of the rounding at worst
  }
}

TEST(Observe, CountsApexesAndMissesThoseThatNeverCome) {
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

TEST(Observe, ReadsBetweenStepsLinearly) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.5);
  const auto reading = observe(scene, trace, of_box(Quantity::y, 0.25), scene.duration);
  EXPECT_DOUBLE_EQ(reading->value, (2 + (2 + 4 - 1.25)) / 2);
}

TEST(Observe, ReadsTheEndWhereNoTimeIsGiven) {
  const Scene scene = fakes::thrown_box();
  const auto reading = observe(scene, fakes::flight_of(scene, 1.0 / 60), of_box(Quantity::x), scene.duration);
  EXPECT_DOUBLE_EQ(reading->time, 2);
  EXPECT_NEAR(reading->value, 7, 1e-12);
}

TEST(Observe, ReadsNothingAfterATraceBrokeOff) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.1);
  EXPECT_FALSE(observe(scene, trace, of_box(Quantity::x, 2.5), scene.duration));
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
}  // namespace plumb
