#include "reports/judge/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../fakes.h"

namespace plumb::rounding_test {
namespace {

// An engine in float that only adds: the bound holds, and is too narrow to hide an error of the method.
TEST(QuantityRounding, BoundsTheErrorOfFloats) {
  const Scene scene = fakes::thrown_box();
  constexpr double dt = 1e-3;
  Trace trace(1);
  float y = 2;
  float v = 8;
  for (int i = 0; i <= 2000; ++i) {
    const BodyState state{.position = {0, y}, .velocity = {0, v}};
    trace.record(i * dt, std::span(&state, 1), {});
    v += static_cast<float>(dt) * -10.0F;
    y += static_cast<float>(dt) * v;
  }
  const Stepping stepping{.dt = dt, .h = dt, .epsilon = std::numeric_limits<float>::epsilon() / 2};
  const double exact = 2 + 8 * 2 - 10 * 2 * 2 / 2.0 - 10 * 2 * dt / 2;  // of symplectic Euler
  const double lost = std::abs(trace.states(2000)[0].position.y - exact);
  const double bound = quantity_rounding(Quantity::y, 0, scene, trace, stepping);
  EXPECT_GT(lost, 0);
  EXPECT_LE(lost, bound);
  EXPECT_LT(bound, 0.003);
}

// Verlet keeps a velocity as the difference of two positions: its error is that of places over the step, once a step.
TEST(QuantityRounding, BoundsTheErrorOfVelocitiesThatAreDifferencesOfPositions) {
  const Scene scene = fakes::thrown_box();
  constexpr double dt = 1e-3;
  Trace trace(1);
  float y = 2;
  float before = y - static_cast<float>(8 * dt);
  for (int i = 0; i <= 2000; ++i) {
    const BodyState state{.position = {0, y}, .velocity = {0, (y - before) / dt}};
    trace.record(i * dt, std::span(&state, 1), {});
    const float next = y + (y - before) - static_cast<float>(10 * dt * dt);
    before = y;
    y = next;
  }
  Stepping stepping{.dt = dt, .h = dt, .epsilon = std::numeric_limits<float>::epsilon() / 2};
  const double lost = std::abs(trace.states(2000)[0].velocity.y - (8 - 10 * 2));
  EXPECT_GT(lost, quantity_rounding(Quantity::vy, 0, scene, trace, stepping));
  stepping.differenced_velocities = true;
  EXPECT_LE(lost, quantity_rounding(Quantity::vy, 0, scene, trace, stepping));
}

}  // namespace
}  // namespace plumb::rounding_test
