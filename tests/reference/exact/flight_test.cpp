#include "reference/exact/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::flight_test {
namespace {

namespace ballistic_tests {

const BodyState start{.position = {1, 2}, .angle = 0.3, .velocity = {3, 4}, .angular_velocity = -5};

BodyState at(double t) {
  BodyState state;
  Ballistic({start}, {{0.5, -10}}).at(t, {&state, 1});
  return state;
}

TEST(Ballistic, AgreesWithRungeKutta) {
  std::array<double, 6> y{1, 2, 0.3, 3, 4, -5};
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    y = runge_kutta(y, 2.0 / steps, [](const std::array<double, 6>& now) {
      return std::array<double, 6>{now[3], now[4], now[5], 0.5, -10, 0};
    });
  }
  const BodyState state = at(2);
  EXPECT_NEAR(state.position.x, y[0], 1e-9 * 10);
  EXPECT_NEAR(state.position.y, y[1], 1e-9 * 10);
  EXPECT_NEAR(state.angle, y[2], 1e-9 * 10);
  EXPECT_NEAR(state.velocity.x, y[3], 1e-9 * 10);
  EXPECT_NEAR(state.velocity.y, y[4], 1e-9 * 10);
  EXPECT_EQ(state.angular_velocity, -5);
}

TEST(Ballistic, KeepsTheEnergyPerMass) {
  const auto energy = [](const BodyState& s) {
    return dot(s.velocity, s.velocity) / 2 - dot(Vec{0.5, -10}, s.position);
  };
  for (const double t : {0.1, 1.0, 7.0}) EXPECT_NEAR(energy(at(t)), energy(start), 1e-12 * 2500);
}

TEST(Ballistic, StartsWhereItStarts) {
  EXPECT_EQ(at(0).position, start.position);
  EXPECT_EQ(at(0).velocity, start.velocity);
}

}  // namespace ballistic_tests

namespace first_contact_tests {

const Floor ground{.normal = {0, 1}};
const Vec gravity{0, -10};

double lowest(const std::vector<Corner>& corners, const BodyState& state) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corner& corner : corners) least = std::min(least, clearance(corner, state, ground));
  return least;
}

// Looks at a hundred thousand times, then bisects the interval in which the body first went below the floor.
double scan(const std::vector<Corner>& corners, const BodyState& start, double horizon) {
  constexpr int samples = 100000;
  for (int i = 1; i <= samples; ++i) {
    double high = horizon * i / samples;
    if (lowest(corners, free_flight(start, gravity, high)) >= 0) continue;
    double low = horizon * (i - 1) / samples;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (lowest(corners, free_flight(start, gravity, middle)) < 0 ? high : low) = middle;
    }
    return high;
  }
  return horizon;
}

TEST(FirstContact, IsTheOneThatAScanFinds) {
  const std::vector<Corner> corners = corners_of(box("box", {0, 0}, {2, 0.2}, {}));
  for (int i = 0; i < 40; ++i) {
    const BodyState start{
        .position = {0, 3}, .angle = 0.37 * i, .velocity = {1, 0.1 * i}, .angular_velocity = -9 + 0.45 * i};
    const std::optional<FloorContact> contact = first_contact(start, gravity, corners, ground, 3);
    ASSERT_TRUE(contact) << i;
    EXPECT_NEAR(contact->time, scan(corners, start, 3), 1e-12) << i;
  }
}

TEST(FirstContact, OfADiscNeedsNoScan) {
  const std::vector<Corner> corners = corners_of(disc("disc", {0, 0}, 0.5, {}));
  const BodyState start{.position = {0, 4.5}, .angular_velocity = 20};
  EXPECT_NEAR(first_contact(start, gravity, corners, ground, 2)->time, std::sqrt(0.8), 1e-15);
}

TEST(FirstContact, SkipsAContactThatItStartsWith) {
  const std::vector<Corner> corners = corners_of(disc("disc", {0, 0}, 0.5, {}));
  const BodyState start{.position = {0, 0.5}, .velocity = {0, 5}};
  EXPECT_NEAR(first_contact(start, gravity, corners, ground, 2)->time, 1, 1e-15);
}

TEST(FirstContact, IsNulloptIfNothingFalls) {
  const std::vector<Corner> corners = corners_of(box("box", {0, 0}, {1, 1}, {}));
  EXPECT_FALSE(first_contact({.position = {0, 3}, .angular_velocity = 4}, {}, corners, ground, 100));
  EXPECT_FALSE(first_contact({.position = {0, 3}, .velocity = {0, -0.01}}, {}, corners, ground, 100));
  EXPECT_NEAR(first_contact({.position = {0, 3}, .velocity = {0, -1}}, {}, corners, ground, 100)->time, 2.5, 1e-15);
}

TEST(CornersOf, AreMeasuredFromTheCentreOfMass) {
  const Body triangle{.shapes = {{.geometry = Polygon{{{0, 0}, {3, 0}, {0, 3}}}, .surface = {}}}};
  const std::vector<Corner> corners = corners_of(triangle);
  ASSERT_EQ(corners.size(), 3u);
  EXPECT_NEAR(corners[0].offset.x, -1, 1e-15);
  EXPECT_NEAR(corners[1].offset.x, 2, 1e-15);
}

}  // namespace first_contact_tests

}  // namespace
}  // namespace plumb::flight_test
