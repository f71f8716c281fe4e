#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "scenarios/scenario.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::contact_test {
namespace {

using statement_of::Of;

constexpr double radius = 0.5;
constexpr double base = 12;

Scene scene_of(double degrees) {
  const Scenario& family = *Catalog<Scenario>::find("disc-on-wedge");
  return family.scene(complete(family, {{"angle", degrees}}));
}

double expected(double degrees, Quantity quantity) {
  return *Of{"disc-on-wedge", {{"angle", degrees}}, "disc", quantity}.expectations().front().expected;
}

// Distance of a point from the face, which falls from (0, base tan a) to (base, 0).
double above_face(Vec at, double angle) {
  return at.x * std::sin(angle) + (at.y - base * std::tan(angle)) * std::cos(angle);
}

// Without friction v^2 = 2 g h, on the face all the way, and the height falls as its slope says.
TEST(DiscOnWedge, KeepsItsEnergyOnTheFace) {
  for (const double degrees : {5.0, 30.0, 60.0}) {
    const double angle = degrees * std::acos(-1) / 180;
    const Vec start = scene_of(degrees).bodies[1].position;
    const Vec end{expected(degrees, Quantity::x), expected(degrees, Quantity::y)};
    EXPECT_NEAR(above_face(start, angle), radius, 1e-12) << degrees;
    EXPECT_NEAR(above_face(end, angle), radius, 1e-12) << degrees;
    EXPECT_NEAR(std::pow(expected(degrees, Quantity::speed), 2), 2 * 10 * (start.y - end.y), 1e-9) << degrees;
    EXPECT_LT(end.x, base) << "still on the face";
  }
}

// In steps of 10 microseconds, under gravity and the face's push, which takes what would lead into it.
TEST(DiscOnWedge, AgreesWithAnIntegrationInSmallSteps) {
  const double angle = std::acos(-1) / 6;
  Vec at = scene_of(30).bodies[1].position;
  Vec v{0, 0};
  constexpr double h = 1e-5;
  for (int i = 0; i < 100000; ++i) {
    const double push = 10 * std::cos(angle);
    v = {v.x + h * push * std::sin(angle), v.y + h * (push * std::cos(angle) - 10)};
    at = {at.x + h * v.x, at.y + h * v.y};
  }
  EXPECT_NEAR(expected(30, Quantity::x), at.x, 1e-4);
  EXPECT_NEAR(expected(30, Quantity::y), at.y, 1e-4);
}

// A disc that rolled would be slower by a third, and turn.
TEST(DiscOnWedge, StopsADiscThatRolls) {
  const double speed = expected(30, Quantity::speed);
  for (const Stepping& stated : statement_of::all()) {
    EXPECT_LT((Of{"disc-on-wedge", {}, "disc", Quantity::speed}.allows(stated)), speed / 3 / 10);
    EXPECT_LT((Of{"disc-on-wedge", {}, "disc", Quantity::angular_velocity}.allows(stated)),
              2. / 3 * speed / radius / 10);
  }
}

double expected(double angle, double ratio, const std::string& body, Quantity quantity) {
  return *Of{"free-wedge", {{"angle", angle}, {"ratio", ratio}}, body, quantity}.expectations().front().expected;
}

// After a second: horizontal momentum, energy (the box has fallen by vy t/2), and the box still on the slope.
TEST(FreeWedge, KeepsMomentumAndEnergyAndTheBoxOnTheSlope) {
  for (const double degrees : {20.0, 30.0, 40.0}) {
    for (const double ratio : {1.0, 2.0, 50.0}) {
      const double back = expected(degrees, ratio, "wedge", Quantity::vx);
      const double vx = expected(degrees, ratio, "box", Quantity::vx);
      const double vy = expected(degrees, ratio, "box", Quantity::vy);
      EXPECT_NEAR(ratio * back + vx, 0, 1e-12);
      EXPECT_NEAR((ratio * back * back + vx * vx + vy * vy) / 2, 10 * -vy / 2, 1e-12);
      EXPECT_NEAR(vy, -(vx - back) * std::tan(degrees * std::numbers::pi / 180), 1e-12);
    }
  }
}

TEST(FreeWedge, StopsAWedgeThatCountsAsFixed) {
  const double fixed = 10 * 0.5 * std::sqrt(0.75);  // g sin cos t
  const Of speed{"free-wedge", {}, "box", Quantity::vx};
  EXPECT_LT(speed.allows(statement_of::accurate()), std::abs(fixed - *speed.expectations().front().expected) / 10);
  EXPECT_LT((Of{"free-wedge", {}, "wedge", Quantity::vx}.allows_at_most()), -expected(30, 2, "wedge", Quantity::vx));
}

double of_dome(const Parameters& changes, Quantity quantity) {
  return *Of{"dome", changes, "disc", quantity}.expectations().back().expected;
}

double leaving_speed(double share, double degrees) {
  const double cosine = share * std::cos(degrees * std::numbers::pi / 180);
  return std::sqrt(10 * 2 * cosine) * cosine;
}

// At the moment it leaves, v^2 = g R cos a, and vx stays after that. The cosine follows from energy: without friction
// v^2 = 2 g R (cos0 - cos), and of a disc that rolls 4/3 g R (cos0 - cos).
TEST(Dome, LosesASmoothDiscAtTwoThirdsOfTheCosine) {
  for (const double degrees : {10.0, 20.0, 45.0}) {
    EXPECT_NEAR(of_dome({{"angle", degrees}}, Quantity::vx), leaving_speed(2.0 / 3, degrees), 1e-9);
    EXPECT_EQ(of_dome({{"angle", degrees}}, Quantity::angular_velocity), 0);
  }
}

// However rough, it slips at last; the difference to rolling all the way vanishes with 1/mu.
TEST(Dome, LosesAVeryRoughDiscAtFourSeventhsOfTheCosine) {
  const double rolled = leaving_speed(4.0 / 7, 20);
  const double ten = of_dome({{"friction", 10}}, Quantity::vx) - rolled;
  const double twenty = of_dome({{"friction", 20}}, Quantity::vx) - rolled;
  EXPECT_LT(std::abs(ten), 0.01);
  EXPECT_LT(std::abs(twenty), 0.6 * std::abs(ten));
}

// What never leaves, or a hoop: w^2 of one half of a slider's in place of two thirds.
TEST(Dome, StopsASmoothDiscThatIsTakenForARollingOne) {
  const Of speed{"dome", {}, "disc", Quantity::vx};
  for (const Stepping& stated : statement_of::all()) {
    if (stated.order == 1) continue;  // their tolerance is larger: half a step of a motion that grows
    EXPECT_LT(speed.allows(stated), leaving_speed(2.0 / 3, 20) - leaving_speed(4.0 / 7, 20));
  }
}

constexpr double table_radius = 0.5;

double of_table_edge(const Parameters& changes, Quantity quantity) {
  return *Of{"table-edge", changes, "disc", quantity}.expectations().back().expected;
}

// Where the load vanishes, v^2 = g r cos a; rolling all the way, 3/4 v^2 + g r cos a is kept: cos a = 4/7 + 3 v0^2/(7 g
// r). However rough, it slips at last; the difference vanishes with 1/mu.
TEST(TableEdge, LosesAVeryRoughDiscAtFourSeventhsAndMore) {
  for (const double speed : {0.5, 1.0, 2.0}) {
    const double cosine = 4.0 / 7 + 3 * speed * speed / (7 * 10 * table_radius);
    const double rolled = std::sqrt(10 * table_radius * cosine) * cosine;
    const double ten = of_table_edge({{"speed", speed}, {"friction", 10}}, Quantity::vx) - rolled;
    const double twenty = of_table_edge({{"speed", speed}, {"friction", 20}}, Quantity::vx) - rolled;
    EXPECT_LT(std::abs(ten), 0.01);
    EXPECT_LT(std::abs(twenty), 0.6 * std::abs(ten));
  }
}

// v^2 > g r: a parabola from the edge.
TEST(TableEdge, LetsAFastDiscFlyAtOnce) {
  const auto y = Of{"table-edge", {{"speed", 3}}, "disc", Quantity::y}.expectations().back();
  const Scenario& family = *Catalog<Scenario>::find("table-edge");
  const double flight = family.scene(complete(family, {{"speed", 3}})).duration - 0.31 / 3;
  EXPECT_NEAR(*y.expected, table_radius - 5 * flight * flight, 1e-12);
  EXPECT_EQ(of_table_edge({{"speed", 3}}, Quantity::vx), 3);
  EXPECT_EQ(of_table_edge({{"speed", 3}}, Quantity::angular_velocity), -6);
}

// A disc that slid over the edge without turning faster would keep 2 rad/s.
TEST(TableEdge, StopsADiscThatDoesNotRoll) {
  const double gains = -of_table_edge({}, Quantity::angular_velocity) - 2;
  EXPECT_LT((Of{"table-edge", {}, "disc", Quantity::angular_velocity}.allows(statement_of::accurate())), gains / 5);
}

// The losses at the corners of the chain are proportional to the length of its facets; on the cycloid itself all beads
// are at 0 at the same time.
TEST(Tautochrone, ExpectsAllBeadsAtTheBottomAsFacetsShrink) {
  const Scenario& scenario = *Catalog<Scenario>::find("tautochrone");
  const auto farthest = [&](double facets) {
    double far = 0;
    for (const Expectation& bead : scenario.expectations(complete(scenario, {{"facets", facets}}))) {
      far = std::max(far, std::abs(*bead.expected));
    }
    return far;
  };
  const double coarse = farthest(100);
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(farthest(200) / coarse, 0.5, 0.05);
  EXPECT_NEAR(farthest(1000) / coarse, 0.1, 0.01);
}

}  // namespace
}  // namespace plumb::contact_test
