#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace plumb::catenary_test
