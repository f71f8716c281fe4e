#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::chains_test {
namespace {

using statement_of::Of;

// The forces on every hinge follow from the planks' moments alone: if a plank of weight w has slope tan b under a
// horizontal pull H, the pull on its upper end is H tan b + w/2 upwards. The sum over both banks carries all the
// weight.
TEST(RopeBridge, HangsInEquilibrium) {
  const Scenario& scenario = *Catalog<Scenario>::find("rope-bridge");
  for (const double ratio : {1.0, 50.0}) {
    const Scene scene = scenario.scene(complete(scenario, {{"ratio", ratio}}));
    const auto slope = [&](int link) { return std::tan(scene.bodies[static_cast<std::size_t>(link)].angle); };
    const double plank = mass_of(scene.bodies[1]).mass;
    const double load = mass_of(scene.bodies.back()).mass;
    EXPECT_NEAR(load / plank, ratio, 1e-12 * ratio);
    // Links 1 ... 12 run from the left bank to the right; the load hangs between 6 and 7.
    const double pull = plank / (slope(8) - slope(7));
    for (int link = 1; link < 12; ++link) {
      const double hung = link == 6 ? load + plank : plank;
      EXPECT_NEAR(pull * (slope(link + 1) - slope(link)), hung, 1e-9 * load) << ratio << ' ' << link;
    }
    const double length = 12 * 0.5;
    EXPECT_NEAR(scene.bodies[13].position.x - scene.bodies[0].position.x, 0.9 * length, 1e-12);
  }
}

TEST(ChainRow, HasAChainOfEachLength) {
  const Scenario& family = *Catalog<Scenario>::find("chain-row");
  const Scene scene = family.scene(complete(family, {}));
  EXPECT_EQ(scene.joints.size(), 55u);
  EXPECT_EQ(*Of({"chain-row", {}, "link 10 of 10", Quantity::y}).expectations().front().expected, -9.5 * 0.4);
  EXPECT_EQ(*Of({"chain-row", {}, "link 1 of 1", Quantity::y}).expectations().front().expected, -0.5 * 0.4);
}

// A link that is let go falls by 45 m.
TEST(ChainRow, StopsAChainThatBreaks) {
  EXPECT_LT((Of{"chain-row", {}, "link 10 of 10", Quantity::y}.allows_at_most()), 0.1);
}

// Box2D 3 lets the longest chain sag by 7.036 mm.
TEST(ChainRow, KnowsHowFarAChainOnSpringsSags) {
  const Of last{"chain-row", {}, "link 10 of 10", Quantity::y};
  Stepping stated = statement_of::soft();
  const double with = last.allows(stated);
  stated.joint_frequency = 0;
  EXPECT_NEAR(with - last.allows(stated), 0.007036, 1e-6);
}

double expected(const Parameters& changes, const char* rod, Quantity quantity) {
  return *Of{"catenary", changes, rod, quantity}.expectations().front().expected;
}

TEST(Catenary, HasALevelRodInItsMiddle) {
  EXPECT_NEAR(expected({{"rods", 7}}, "rod 4", Quantity::angle), 0, 1e-12);
  EXPECT_LT(expected({{"rods", 7}}, "rod 1", Quantity::angle), -0.5);
}

// y = a cosh(x/a), of the length 2 a sinh(s/(2 a)): many rods hang like a rope.
TEST(Catenary, IsAlmostARopeOfManyRods) {
  constexpr double length = 4;
  for (const double share : {0.5, 0.7, 0.9}) {
    const double span = share * length;
    double low = 0.01;
    double high = 100;
    for (int i = 0; i < 100; ++i) {
      const double a = (low + high) / 2;
      (2 * a * std::sinh(span / (2 * a)) > length ? low : high) = a;
    }
    const double sag = low * (std::cosh(span / (2 * low)) - 1);
    const double off5 = expected({{"rods", 5}, {"span", share}}, "rod 3", Quantity::y) + sag;
    const double off11 = expected({{"rods", 11}, {"span", share}}, "rod 6", Quantity::y) + sag;
    EXPECT_LT(std::abs(off11), 0.03) << share;
    EXPECT_NEAR(off11 * 11 * 11 / (off5 * 5 * 5), 1, 0.3) << "of second order in the rods' length";
  }
}

// The fold from which it starts is higher by decimetres.
TEST(Catenary, StopsAChainThatStaysFolded) {
  EXPECT_LT((Of{"catenary", {}, "rod 4", Quantity::y}.allows(statement_of::accurate())), 0.001);
}

double span(double rods, double pull) {
  return *Of{"pulled-chain", {{"rods", rods}, {"pull", pull}}, "sled", Quantity::x}.expectations().front().expected;
}

// y = a cosh(x/a) has the tension a times the weight per length, and the length 2 a sinh(s/(2 a)).
TEST(PulledChain, SpansAlmostWhatARopeDoes) {
  constexpr double length = 4;
  for (const double pull : {0.8, 1.0, 3.0}) {
    const double a = pull * length;
    const double rope = 2 * a * std::asinh(length / (2 * a));
    EXPECT_NEAR(span(12, pull), rope, 0.005);
    EXPECT_NEAR((span(12, pull) - rope) * 144 / ((span(6, pull) - rope) * 36), 1, 0.1) << "of second order";
  }
}

// The pull that the rods' slants need is that of the scene: at the pin they hold half of the chain's weight, and on
// half a rod less the first one slants.
TEST(PulledChain, IsInEquilibriumWithTheScenesForce) {
  const Scenario& family = *Catalog<Scenario>::find("pulled-chain");
  const Scene scene = family.scene(complete(family, {}));
  const double rod = mass_of(scene.bodies[1]).mass * 10;
  const double pull = std::get<Constant>(scene.forces[0]).force.x;
  const double slant = *Of{"pulled-chain", {}, "rod 1", Quantity::angle}.expectations().front().expected;
  EXPECT_NEAR(std::tan(slant), -(8 / 2.0 - 0.5) * rod / pull, 1e-12);
}

// It starts at .7 of the span.
TEST(PulledChain, StopsAChainThatIsNotPulled) {
  EXPECT_LT((Of{"pulled-chain", {}, "sled", Quantity::x}.allows_at_most()), 0.3 * span(8, 1) / 2);
}

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
}  // namespace plumb::chains_test
