#include "reports/gate/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../fakes.h"

namespace plumb {
namespace {

constexpr double single = std::numeric_limits<float>::epsilon() / 2;

Stepping steps_of(double dt, double epsilon) { return {.dt = dt, .h = dt, .drift = 0.5, .epsilon = epsilon}; }

// y of a falling body, each sum rounded to single precision, against the same sums in double.
double rounded_off(double dt, std::size_t steps) {
  double y = 2, v = 8;
  auto y_single = static_cast<float>(y), v_single = static_cast<float>(v);
  for (std::size_t i = 0; i < steps; ++i) {
    v -= 10 * dt;
    y += dt * v;
    v_single -= static_cast<float>(10 * dt);
    y_single += static_cast<float>(dt) * v_single;
  }
  return std::abs(static_cast<double>(y_single) - y);
}

TEST(RoundingOfARun, ExplainsWhatSinglePrecisionIsOff) {
  const Scene scene = fakes::thrown_box();
  for (const double dt : {1.0 / 60, 1.0 / 100, 1.0 / 240, 1.0 / 1000}) {
    const Trace trace = fakes::flight_of(scene, dt);
    const Rounding rounding(scene, trace, steps_of(dt, single));
    const double off = rounded_off(dt, trace.size() - 1);
    EXPECT_LT(off, 10 * rounding.of("m")) << dt;
    EXPECT_GT(off, 0.0001 * rounding.of("m")) << dt;
  }
}

TEST(RoundingOfARun, GrowsAsARandomWalkWithTheNumberOfSteps) {
  const Scene scene = fakes::thrown_box();
  const auto of = [&](double dt) { return Rounding(scene, fakes::flight_of(scene, dt), steps_of(dt, single)).of("m"); };
  EXPECT_NEAR(of(1.0 / 1600) / of(1.0 / 100), 4, 0.1);
}

TEST(RoundingOfARun, KnowsTheUnitsOfAllNumbers) {
  const Scene scene = fakes::thrown_box();
  const Rounding rounding(scene, fakes::flight_of(scene, 0.01), steps_of(0.01, single));
  for (const char* unit : {"m", "m/s", "rad", "rad/s", "J", "1", "N", "N s", "N m", "kg m/s", "kg m^2/s"}) {
    EXPECT_GT(rounding.of(unit), 0) << unit;
    EXPECT_TRUE(std::isfinite(rounding.of(unit))) << unit;
  }
  EXPECT_EQ(rounding.of("bananas"), 0);
}

TEST(RoundingOfARun, TakesAClosedFormToBeEvaluatedInDouble) {
  const Scene scene = fakes::thrown_box();
  const Trace trace = fakes::flight_of(scene, 0.01);
  EXPECT_EQ(Rounding(scene, trace, steps_of(0.01, 0)).of("m"),
            Rounding(scene, trace, steps_of(0.01, std::numeric_limits<double>::epsilon())).of("m"));
}

}  // namespace
}  // namespace plumb
