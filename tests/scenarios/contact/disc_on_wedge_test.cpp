#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::disc_on_wedge_test {
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

}  // namespace
}  // namespace plumb::disc_on_wedge_test
