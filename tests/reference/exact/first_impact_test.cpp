#include "reference/exact/first_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scenarios/parts.h"

namespace plumb {
namespace {

FirstImpact::Case landing() {
  return {.start = {.position = {0, 2}, .angle = -0.5, .velocity = {4, 0}, .angular_velocity = 0.5},
          .mass = 0.5,
          .inertia = 0.5 * 1.25 / 12,
          .gravity = {0, -10},
          .corners = corners_of(box("box", {0, 0}, {1, 0.5}, {})),
          .floor = {.normal = {0, 1}},
          .friction = 0.2,
          .restitution = 0.5,
          .horizon = 10};
}

FirstImpact solved(const FirstImpact::Case& given) { return std::get<FirstImpact>(FirstImpact::solve(given)); }

double energy(const BodyState& s) {
  const FirstImpact::Case c = landing();
  return c.mass * (dot(s.velocity, s.velocity) / 2 + 10 * s.position.y) +
         c.inertia * s.angular_velocity * s.angular_velocity / 2;
}

TEST(FirstImpact, IsWhereACornerMeetsTheFloor) {
  const FirstImpact motion = solved(landing());
  double least = 1;
  for (const Corner& corner : landing().corners) {
    least = std::min(least, clearance(corner, motion.at(motion.impact()), landing().floor));
  }
  EXPECT_NEAR(least, 0, 1e-15);
}

TEST(FirstImpact, MovesNothingButSpeedsAtTheImpact) {
  const FirstImpact motion = solved(landing());
  const double t = motion.impact();
  const double before = std::nextafter(t, 0.0);
  EXPECT_NEAR(motion.at(before).position.y, motion.at(t).position.y, 1e-14);
  EXPECT_NEAR(motion.at(before).angle, motion.at(t).angle, 1e-14);
  EXPECT_GT(motion.at(t).velocity.y, motion.at(before).velocity.y + 1);
}

TEST(FirstImpact, KeepsTheEnergyButForTheImpact) {
  const FirstImpact motion = solved(landing());
  const double t = motion.impact();
  EXPECT_NEAR(energy(motion.at(0)), energy(motion.at(t * 0.99)), 1e-13);
  EXPECT_LT(energy(motion.at(t)), energy(motion.at(0)) - 0.1);
  EXPECT_NEAR(energy(motion.at(t)), energy(motion.at((t + motion.valid_until()) / 2)), 1e-13);
}

TEST(FirstImpact, EndsAtTheSecondContact) {
  const FirstImpact motion = solved(landing());
  EXPECT_GT(motion.valid_until(), motion.impact());
  double least = 1;
  for (const Corner& corner : landing().corners) {
    least = std::min(least, clearance(corner, motion.at(motion.valid_until()), landing().floor));
  }
  EXPECT_NEAR(least, 0, 1e-14);
}

TEST(FirstImpact, HoldsForEverWhereNothingIsHit) {
  FirstImpact::Case high = landing();
  high.start.position.y = 1e4;
  EXPECT_EQ(solved(high).impact(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(solved(high).valid_until(), std::numeric_limits<double>::infinity());
}

TEST(FirstImpact, OfADiscBouncesBackToESquaredH) {
  FirstImpact::Case drop = landing();
  drop.start = {.position = {0, 4.5}};
  drop.corners = corners_of(disc("disc", {0, 0}, 0.5, {}));
  drop.restitution = 0.8;
  const FirstImpact motion = solved(drop);
  EXPECT_NEAR(motion.at((motion.impact() + motion.valid_until()) / 2).position.y, 0.5 + 0.64 * 4, 1e-14);
}

TEST(FirstImpact, RefusesWhatTheLawsDoNotSettle) {
  FirstImpact::Case flat_landing = landing();
  flat_landing.start.angle = 0;
  flat_landing.start.angular_velocity = 0;
  EXPECT_TRUE(std::holds_alternative<std::string>(FirstImpact::solve(flat_landing)));
  FirstImpact::Case trips = landing();
  trips.start.velocity.x = -4;
  trips.friction = 1;
  EXPECT_TRUE(std::holds_alternative<std::string>(FirstImpact::solve(trips)));
  FirstImpact::Case sunk = landing();
  sunk.start.position.y = 0;
  EXPECT_TRUE(std::holds_alternative<std::string>(FirstImpact::solve(sunk)));
}

}  // namespace
}  // namespace plumb
