#include "reports/trace.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace plumb::trace_test {
namespace {

Trace two_moments() {
  Trace trace(1);
  const BodyState first{.position = {0, 0}, .angle = 1, .velocity = {2, 0}, .angular_velocity = 0};
  const BodyState second{.position = {4, 8}, .angle = 2, .velocity = {2, 4}, .angular_velocity = 8};
  const ContactState contact{.a = 0, .b = 0, .separation = -1};
  trace.record(1, std::span(&first, 1), {});
  trace.record(3, std::span(&second, 1), std::span(&contact, 1));
  return trace;
}

TEST(Trace, InterpolatesLinearlyBetweenSteps) {
  const BodyState quarter = two_moments().state_at(0, 1.5);
  EXPECT_EQ(quarter.position, (Vec{1, 2}));
  EXPECT_EQ(quarter.angle, 1.25);
  EXPECT_EQ(quarter.velocity, (Vec{2, 1}));
  EXPECT_EQ(quarter.angular_velocity, 2);
}

TEST(Trace, IsConstantBeyondItsEnds) {
  EXPECT_EQ(two_moments().state_at(0, 0).position, (Vec{0, 0}));
  EXPECT_EQ(two_moments().state_at(0, 9).position, (Vec{4, 8}));
}

TEST(Trace, KeepsTheContactsOfEachMomentApart) {
  const Trace trace = two_moments();
  EXPECT_TRUE(trace.contacts(0).empty());
  ASSERT_EQ(trace.contacts(1).size(), 1u);
  EXPECT_EQ(trace.contacts(1)[0].separation, -1);
}

TEST(Trace, RefusesMissingBodiesAndATimeThatDoesNotIncrease) {
  Trace trace(1);
  const BodyState state;
  EXPECT_THROW(trace.record(0, {}, {}), std::invalid_argument);
  trace.record(0, std::span(&state, 1), {});
  EXPECT_THROW(trace.record(0, std::span(&state, 1), {}), std::invalid_argument);
  EXPECT_THROW(Trace(1).state_at(0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace plumb::trace_test
