#include "impulse/clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace clock_test {
namespace {

using namespace impulse;

TEST(FrameClock, SpendsRealTimeInEqualSteps) {
  FrameClock clock(0.25, 10);
  EXPECT_EQ(clock.advance(0.125), 0);
  EXPECT_EQ(clock.alpha(), 0.5);
  EXPECT_EQ(clock.advance(0.125), 1);  // a step is due as soon as its time has accumulated
  EXPECT_EQ(clock.alpha(), 0);
  EXPECT_EQ(clock.advance(1.125), 4);
  EXPECT_EQ(clock.alpha(), 0.5);
}

TEST(FrameClock, GivesTheSameStepsForTheSameFrames) {
  FrameClock a(1.0 / 60);
  FrameClock b(1.0 / 60);
  for (int i = 0; i < 1000; ++i) {
    const double frame = 0.001 * (1 + i * 7919 % 40);
    ASSERT_EQ(a.advance(frame), b.advance(frame));
    ASSERT_EQ(a.alpha(), b.alpha());
  }
}

// Without the clamp, a step that takes longer than dt demands more steps in each frame: the spiral of death.
TEST(FrameClock, NeverDemandsMoreStepsThanItsClampAllows) {
  FrameClock clock(1.0 / 60, 0.2);
  EXPECT_LE(clock.advance(10), 12);
  EXPECT_LT(clock.alpha(), 1);
  EXPECT_LE(clock.advance(std::numeric_limits<double>::infinity()), 12);
}

TEST(FrameClock, IgnoresInvalidFrameTimes) {
  FrameClock clock(1.0 / 64);
  EXPECT_EQ(clock.advance(-1), 0);
  EXPECT_EQ(clock.advance(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(clock.alpha(), 0);
}

TEST(FrameClock, RejectsInvalidSteps) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FrameClock(0), std::invalid_argument);
  EXPECT_THROW(FrameClock(-1), std::invalid_argument);
  EXPECT_THROW(FrameClock{nan}, std::invalid_argument);
  EXPECT_THROW(FrameClock(1, 0.5), std::invalid_argument);
  EXPECT_THROW(FrameClock(1, nan), std::invalid_argument);
  EXPECT_THROW(FrameClock(1, std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(FrameClock(1e-9, 1), std::invalid_argument);
}

/// The largest drawing error of a body that moves at 1 m/s, drawn at irregular frame times. Drawing should show the
/// position one step ago.
template <class Blend>
double drawing_error(const Blend& blend_by) {
  constexpr double dt = 1.0 / 64;
  FrameClock clock(dt);
  double now = 0;
  double worst = 0;
  int steps = 0;
  for (const double frame : {.011, .017, .023, .005, .031, .016, .002, .019, .027, .013, .008, .021}) {
    now += frame;
    steps += clock.advance(frame);
    const Real previous = static_cast<Real>((steps - 1) * dt);
    const Real current = static_cast<Real>(steps * dt);
    const double drawn = static_cast<double>(blend_by(previous, current, clock.alpha()));
    worst = std::max(worst, std::abs(drawn - (now - dt)));
  }
  return worst;
}

TEST(Blend, DrawsUniformMotionWithoutJitter) {
  EXPECT_LT(drawing_error([](Real previous, Real current, double alpha) { return blend(previous, current, alpha); }),
            1e-6);
}

TEST(Blend, AsPrintedWouldRunBackwards) {
  const auto printed = [](Real previous, Real current, double alpha) {
    const Real a = static_cast<Real>(alpha);
    return previous * a + current * (1 - a);
  };
  EXPECT_GT(drawing_error(printed), 1e-3);
}

TEST(Blend, BlendsPositionsAndAngles) {
  EXPECT_EQ(blend(Vec2{0, 4}, Vec2{2, 8}, 0.25), (Vec2{Real{0.5}, 5}));
  EXPECT_EQ(blend(Real{1}, Real{3}, 0.75), Real{2.5});
}

}  // namespace
}  // namespace clock_test
