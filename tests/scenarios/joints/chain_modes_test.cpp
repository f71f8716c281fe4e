#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::chain_modes_test {
namespace {

using statement_of::Of;

Scene scene_of(const Parameters& changes) {
  const Scenario& family = *Catalog<Scenario>::find("chain-modes");
  return family.scene(complete(family, changes));
}

// w^2 l/g of a small swing, from where the last bead is at the first reading.
double share(double beads, double mode) {
  const Parameters changes{{"beads", beads}, {"mode", mode}, {"angle", 1}};
  const std::string last = "bead " + std::to_string(static_cast<int>(beads));
  const Expectation first = Of{"chain-modes", changes, last, Quantity::x}.expectations().front();
  const double w = std::acos(*first.expected / scene_of(changes).bodies.back().position.x) / *first.time;
  return w * w * 0.5 / 10;
}

TEST(ChainModes, OfTwoBeadsAreThoseOfTheDoublePendulum) {
  EXPECT_NEAR(share(2, 1), 2 - std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(share(2, 2), 2 + std::sqrt(2.0), 3e-3);
}

// w^2 (n l)/g tends to (j/2)^2, with j = 2.4048 the first zero of J0: (n + 1/2) of the share, to second order in 1/n.
TEST(ChainModes, TendToZerosOfTheBesselFunction) {
  const double limit = std::pow(2.404825557695773 / 2, 2);
  EXPECT_NEAR(5.5 * share(5, 1), limit, 0.01);
  EXPECT_NEAR(10.5 * share(10, 1), limit, 0.003);
}

// Two points on rods in Cartesian coordinates: the pulls of the rods from the second derivatives of their lengths.
TEST(ChainModes, MoveAsTwoPointsOnRods) {
  using State = std::array<double, 8>;  // x, y of both, and their velocities
  const auto rate = [](const State& s) {
    const Vec a{s[0], s[1]}, b{s[2] - s[0], s[3] - s[1]};  // the rods
    const Vec va{s[4], s[5]}, vb{s[6] - s[4], s[7] - s[5]};
    const double aa = a.x * a.x + a.y * a.y;
    const double bb = b.x * b.x + b.y * b.y;
    const double ab = a.x * b.x + a.y * b.y;
    // With the pulls p a and q b: a.(-p a + q b - g y) = -va^2, and b.(-2 q b + p a) = -vb^2.
    const double first = va.x * va.x + va.y * va.y - 10 * a.y;  // p aa - q ab
    const double second = vb.x * vb.x + vb.y * vb.y;            // 2 q bb - p ab
    const double determinant = 2 * aa * bb - ab * ab;
    const double p = (2 * bb * first + ab * second) / determinant;
    const double q = (ab * first + aa * second) / determinant;
    return State{s[4], s[5], s[6], s[7], -p * a.x + q * b.x, -p * a.y + q * b.y - 10, -q * b.x, -q * b.y - 10};
  };
  for (const double mode : {1.0, 2.0}) {
    const Parameters changes{{"mode", mode}, {"angle", 10}};
    const Scene scene = scene_of(changes);
    const Vec upper = scene.bodies[1].position;
    const Vec lower = scene.bodies[2].position;
    for (const char* bead : {"bead 1", "bead 2"}) {
      for (const Expectation& one : Of{"chain-modes", changes, bead, Quantity::x}.expectations()) {
        const State end = integrated(State{upper.x, upper.y, lower.x, lower.y}, *one.time, 20000, rate);
        EXPECT_NEAR(*one.expected, end[bead == std::string("bead 1") ? 0 : 2], 1e-8) << mode;
      }
    }
  }
}

// The other mode is 2.4 times as fast.
TEST(ChainModes, StopTheOtherMode) {
  for (const Stepping& stated : statement_of::all()) {
    const Of slow{"chain-modes", {}, "bead 2", Quantity::x};
    EXPECT_LT(slow.allows(stated), std::abs(scene_of({}).bodies[2].position.x) / 5);
  }
}

}  // namespace
}  // namespace plumb::chain_modes_test
