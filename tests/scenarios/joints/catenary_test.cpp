#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::catenary_test {
namespace {

using statement_of::Of;

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

}  // namespace
}  // namespace plumb::catenary_test
