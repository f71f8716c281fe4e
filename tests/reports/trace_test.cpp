#include "reports/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
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

Trace with(const BodyState& state, const ContactState& contact) {
  Trace trace(1);
  trace.record(0, std::span(&state, 1), {});
  trace.record(0.5, std::span(&state, 1), std::span(&contact, 1));
  return trace;
}

TEST(Trace, HasAHashOfEveryBit) {
  const BodyState state{.position = {1, 2}, .angle = 3, .velocity = {4, 5}, .angular_velocity = 6};
  const ContactState contact{.a = 1, .b = 2, .point = {1, 1}, .normal = {0, 1}, .normal_impulse = 7};
  const std::uint64_t hash = hash_of(with(state, contact));
  EXPECT_EQ(hash, hash_of(with(state, contact)));
  const auto up = [](double& number) { number = std::nextafter(number, 100); };
  for (double BodyState::*number : {&BodyState::angle, &BodyState::angular_velocity}) {
    BodyState other = state;
    up(other.*number);
    EXPECT_NE(hash_of(with(other, contact)), hash);
  }
  for (Vec BodyState::*vector : {&BodyState::position, &BodyState::velocity}) {
    BodyState other = state;
    up((other.*vector).y);
    EXPECT_NE(hash_of(with(other, contact)), hash);
  }
  for (double ContactState::*number :
       {&ContactState::normal_impulse, &ContactState::tangent_impulse, &ContactState::separation}) {
    ContactState other = contact;
    up(other.*number);
    EXPECT_NE(hash_of(with(state, other)), hash);
  }
  ContactState other = contact;
  other.b = 3;
  EXPECT_NE(hash_of(with(state, other)), hash);
}

}  // namespace
}  // namespace plumb::trace_test
