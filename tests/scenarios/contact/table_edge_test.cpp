#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::table_edge_test {
namespace {

using statement_of::Of;

constexpr double radius = 0.5;

double expected(const Parameters& changes, Quantity quantity) {
  return *Of{"table-edge", changes, "disc", quantity}.expectations().back().expected;
}

// Where the load vanishes, v^2 = g r cos a; rolling all the way, 3/4 v^2 + g r cos a is kept: cos a = 4/7 + 3 v0^2/(7 g
// r). However rough, it slips at last; the difference vanishes with 1/mu.
TEST(TableEdge, LosesAVeryRoughDiscAtFourSeventhsAndMore) {
  for (const double speed : {0.5, 1.0, 2.0}) {
    const double cosine = 4.0 / 7 + 3 * speed * speed / (7 * 10 * radius);
    const double rolled = std::sqrt(10 * radius * cosine) * cosine;
    const double ten = expected({{"speed", speed}, {"friction", 10}}, Quantity::vx) - rolled;
    const double twenty = expected({{"speed", speed}, {"friction", 20}}, Quantity::vx) - rolled;
    EXPECT_LT(std::abs(ten), 0.01);
    EXPECT_LT(std::abs(twenty), 0.6 * std::abs(ten));
  }
}

// v^2 > g r: a parabola from the edge.
TEST(TableEdge, LetsAFastDiscFlyAtOnce) {
  const auto y = Of{"table-edge", {{"speed", 3}}, "disc", Quantity::y}.expectations().back();
  const Scenario& family = *Catalog<Scenario>::find("table-edge");
  const double flight = family.scene(complete(family, {{"speed", 3}})).duration - 0.31 / 3;
  EXPECT_NEAR(*y.expected, radius - 5 * flight * flight, 1e-12);
  EXPECT_EQ(expected({{"speed", 3}}, Quantity::vx), 3);
  EXPECT_EQ(expected({{"speed", 3}}, Quantity::angular_velocity), -6);
}

// A disc that slid over the edge without turning faster would keep 2 rad/s.
TEST(TableEdge, StopsADiscThatDoesNotRoll) {
  const double gains = -expected({}, Quantity::angular_velocity) - 2;
  EXPECT_LT((Of{"table-edge", {}, "disc", Quantity::angular_velocity}.allows(statement_of::accurate())), gains / 5);
}

}  // namespace
}  // namespace plumb::table_edge_test
