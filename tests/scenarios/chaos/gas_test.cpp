#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "scenarios/scenario.h"

namespace plumb::gas_test {
namespace {

Expectation spread(double side) {
  const Scenario& gas = *Catalog<Scenario>::find("gas");
  for (const Expectation& one : gas.expectations(complete(gas, {{"side", side}}))) {
    if (one.quantity == Quantity::speed_spread) return one;
  }
  throw std::logic_error("expected the gas to have a spread of speeds");
}

// States of one energy, all equally likely: Gaussian velocities scaled to that energy.
TEST(Gas, ExpectsTheMeanOfAllStatesOfItsEnergyWithinAFractionOfTheirSpread) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss;
  for (const double side : {4.0, 16.0}) {
    const double n = side * side;
    constexpr int states = 20000;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < states; ++i) {
      double second = 0;
      double fourth = 0;
      for (int k = 0; k < static_cast<int>(n); ++k) {
        const double square = std::pow(gauss(random), 2) + std::pow(gauss(random), 2);
        second += square;
        fourth += square * square;
      }
      const double ratio = n * fourth / (second * second);
      sum += ratio;
      squares += ratio * ratio;
    }
    const double mean = sum / states;
    const double sigma = std::sqrt(squares / states - mean * mean);
    const Expectation expectation = spread(side);
    EXPECT_NEAR(*expectation.expected, mean, 5 * sigma / std::sqrt(states)) << side;
    // Four sigma of a mean over a time in which the discs forget their speeds fifty times.
    EXPECT_NEAR(expectation.allowed({}) / 4, sigma * std::sqrt(2.0 / 52), 0.08 * sigma) << side;
    EXPECT_NEAR(expectation.chance / 4, sigma * std::sqrt(2.0 / 52), 0.08 * sigma) << side;
  }
}

// Discs that never collide stay equally fast, with a spread of 1: that must not pass.
TEST(Gas, TellsMaxwellsLawFromEqualSpeeds) {
  const Expectation expectation = spread(16);
  EXPECT_GT(*expectation.expected - expectation.allowed({}), 1.3);
}

TEST(Gas, StartsWithDiscsThatAreEquallyFast) {
  const Scenario& gas = *Catalog<Scenario>::find("gas");
  const Scene scene = gas.scene(complete(gas, {}));
  for (const Body& body : scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    EXPECT_NEAR(std::hypot(body.velocity.x, body.velocity.y), 2, 1e-15);
  }
  EXPECT_EQ(scene.bodies.size(), 4u + 256u);
}

}  // namespace
}  // namespace plumb::gas_test
