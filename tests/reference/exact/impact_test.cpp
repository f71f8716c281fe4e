#include "reference/exact/impact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/parts.h"

namespace plumb::impact_test {
namespace {

namespace impact_law_tests {

PointImpact corner(double friction, double restitution) {
  return {.mass = 2,
          .inertia = 0.3,
          .normal = {0, 1},
          .arm = {0.3, -0.4},
          .velocity = {4, -5},
          .spin = 1,
          .friction = friction,
          .restitution = restitution};
}

struct After {
  Vec velocity;
  double spin = 0;
  Vec point;  // velocity of the point that touched
};

After after(const PointImpact& m, Vec push) {
  After state{m.velocity + (1 / m.mass) * push, m.spin + cross(m.arm, push) / m.inertia, {}};
  state.point = state.velocity + state.spin * perpendicular(m.arm);
  return state;
}

// Keller's method: integrates the impact over the normal impulse, with friction against the present slip. When the
// approach ends, Poisson's restitution adds e times the impulse of compression.
Vec integrate(PointImpact m) {
  const Vec n = m.normal;
  const Vec t{n.y, -n.x};
  const auto point = [&m] { return m.velocity + m.spin * perpendicular(m.arm); };
  Vec total;
  const auto push = [&](double pn) {
    const double slip = dot(point(), t);
    const Vec bit = pn * (n - (slip > 0 ? m.friction : -m.friction) * t);
    m.velocity = m.velocity + (1 / m.mass) * bit;
    m.spin += cross(m.arm, bit) / m.inertia;
    total = total + bit;
  };
  constexpr double bit = 1e-3;
  double before = dot(point(), n);
  for (double pn = bit;; pn += bit) {
    push(bit);
    const double after = dot(point(), n);
    if (after < 0) {
      before = after;
      continue;
    }
    const double compression = pn - bit * after / (after - before);
    for (double left = (1 + m.restitution) * compression - pn; left != 0;) {
      const double part = std::min(left, bit);
      push(part);
      left -= part;
    }
    return total;
  }
}

TEST(ImpactImpulse, AgreesWithKellersProcessWhileTheSlipKeepsItsDirection) {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double mu : {0.0, 0.1, 0.2}) {
      const PointImpact meeting = corner(mu, e);
      const std::optional<Vec> push = impact_impulse(meeting);
      ASSERT_TRUE(push);
      ASSERT_GT(after(meeting, *push).point.x, 0) << "this test needs slip that continues";
      const Vec expected = integrate(meeting);
      EXPECT_NEAR(push->x, expected.x, 1e-9);
      EXPECT_NEAR(push->y, expected.y, 1e-9);
    }
  }
}

TEST(ImpactImpulse, WithoutFrictionIsTheTextbookFormula) {
  const PointImpact m = corner(0, 0.5);
  const double un = -5 + 1 * 0.3;
  EXPECT_DOUBLE_EQ(impact_impulse(m)->y, -1.5 * un / (1 / 2.0 + 0.09 / 0.3));
  EXPECT_EQ(impact_impulse(m)->x, 0);
}

TEST(ImpactImpulse, ReversesTheNormalSpeedByTheRestitution) {
  for (const double mu : {0.0, 0.2}) {
    const PointImpact m = corner(mu, 0.5);
    EXPECT_NEAR(after(m, *impact_impulse(m)).point.y, 0.5 * 4.7, 1e-14);
  }
}

TEST(ImpactImpulse, KeepsAngularMomentumAboutThePointAndLosesEnergy) {
  const PointImpact m = corner(0.2, 0.5);
  const After then = after(m, *impact_impulse(m));
  const auto about_point = [&m](Vec v, double w) { return m.inertia * w - m.mass * cross(m.arm, v); };
  const auto energy = [&m](Vec v, double w) { return (m.mass * dot(v, v) + m.inertia * w * w) / 2; };
  EXPECT_NEAR(about_point(then.velocity, then.spin), about_point(m.velocity, m.spin), 1e-14);
  EXPECT_LT(energy(then.velocity, then.spin), energy(m.velocity, m.spin));
  const PointImpact elastic = corner(0, 1);
  const After back = after(elastic, *impact_impulse(elastic));
  EXPECT_NEAR(energy(back.velocity, back.spin), energy(elastic.velocity, elastic.spin), 1e-14);
}

// A disc: Jn = m (1+e) vn, Jt = min(mu Jn, m vt/3) against vt.
TEST(ImpactImpulse, OfADiscGripsOrSlips) {
  PointImpact disc{
      .mass = 2, .inertia = 0.25, .normal = {0, 1}, .arm = {0, -0.5}, .velocity = {3, -4}, .restitution = 0.5};
  for (const double mu : {0.1, 0.9}) {
    disc.friction = mu;
    disc.spin = 0.4;
    const double vt = 3 + 0.4 * 0.5;
    EXPECT_DOUBLE_EQ(impact_impulse(disc)->y, 12);
    EXPECT_DOUBLE_EQ(impact_impulse(disc)->x, -std::min(mu * 12, 2 * vt / 3));
  }
  EXPECT_NEAR(after(disc, *impact_impulse(disc)).point.x, 0, 1e-15);
}

TEST(ImpactImpulse, IsTheSameInATurnedFrame) {
  const PointImpact m = corner(0.2, 0.5);
  PointImpact there = m;
  there.normal = rotated(m.normal, 0.7);
  there.arm = rotated(m.arm, 0.7);
  there.velocity = rotated(m.velocity, 0.7);
  const Vec expected = rotated(*impact_impulse(m), 0.7);
  EXPECT_NEAR(impact_impulse(there)->x, expected.x, 1e-13);
  EXPECT_NEAR(impact_impulse(there)->y, expected.y, 1e-13);
}

TEST(ImpactImpulse, IsNulloptWhereTheLawsDisagree) {
  PointImpact stops = corner(0.2, 0.5);  // at the opposite corner the normal impulse stops the slip
  stops.arm.x = -0.3;
  EXPECT_FALSE(impact_impulse(stops));
  PointImpact leaving = corner(0.2, 0.5);
  leaving.velocity.y = 5;
  EXPECT_FALSE(impact_impulse(leaving));
}

}  // namespace impact_law_tests

namespace first_impact_tests {

FirstImpact::Setup landing() {
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

FirstImpact solved(const FirstImpact::Setup& given) { return std::get<FirstImpact>(FirstImpact::solve(given)); }

double energy(const BodyState& s) {
  const FirstImpact::Setup c = landing();
  return c.mass * (dot(s.velocity, s.velocity) / 2 + 10 * s.position.y) +
         c.inertia * s.angular_velocity * s.angular_velocity / 2;
}

TEST(FirstImpact, IsWhereACornerTouchesTheFloor) {
  const FirstImpact motion = solved(landing());
  double least = 1;
  for (const Corner& corner : landing().corners) {
    least = std::min(least, clearance(corner, motion.at(motion.impact()), landing().floor));
  }
  EXPECT_NEAR(least, 0, 1e-15);
}

TEST(FirstImpact, ChangesOnlyVelocitiesAtTheImpact) {
  const FirstImpact motion = solved(landing());
  const double t = motion.impact();
  const double before = std::nextafter(t, 0.0);
  EXPECT_NEAR(motion.at(before).position.y, motion.at(t).position.y, 1e-14);
  EXPECT_NEAR(motion.at(before).angle, motion.at(t).angle, 1e-14);
  EXPECT_GT(motion.at(t).velocity.y, motion.at(before).velocity.y + 1);
}

TEST(FirstImpact, KeepsTheEnergyExceptInTheImpact) {
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
  // A run's last step may end after the solution's end.
  auto shorter = landing();
  shorter.horizon = motion.valid_until() - 1e-3;
  EXPECT_EQ(solved(shorter).valid_until(), motion.valid_until());
}

TEST(FirstImpact, EndsAtAFirstContactInTheLastStep) {
  auto shorter = landing();
  const double landed = solved(shorter).impact();
  shorter.horizon = landed - 1e-3;
  EXPECT_EQ(solved(shorter).valid_until(), landed);
}

TEST(FirstImpact, IsValidForEverIfNothingIsHit) {
  FirstImpact::Setup high = landing();
  high.start.position.y = 1e4;
  EXPECT_EQ(solved(high).impact(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(solved(high).valid_until(), std::numeric_limits<double>::infinity());
}

TEST(FirstImpact, OfADiscBouncesBackToESquaredH) {
  FirstImpact::Setup drop = landing();
  drop.start = {.position = {0, 4.5}};
  drop.corners = corners_of(disc("disc", {0, 0}, 0.5, {}));
  drop.restitution = 0.8;
  const FirstImpact motion = solved(drop);
  EXPECT_NEAR(motion.at((motion.impact() + motion.valid_until()) / 2).position.y, 0.5 + 0.64 * 4, 1e-14);
}

TEST(FirstImpact, RefusesCasesThatTheLawsDoNotDetermine) {
  FirstImpact::Setup flat_landing = landing();
  flat_landing.start.angle = 0;
  flat_landing.start.angular_velocity = 0;
  EXPECT_TRUE(std::holds_alternative<std::string>(FirstImpact::solve(flat_landing)));
  FirstImpact::Setup trips = landing();
  trips.start.velocity.x = -4;
  trips.friction = 1;
  EXPECT_TRUE(std::holds_alternative<std::string>(FirstImpact::solve(trips)));
  FirstImpact::Setup sunk = landing();
  sunk.start.position.y = 0;
  EXPECT_TRUE(std::holds_alternative<std::string>(FirstImpact::solve(sunk)));
}

}  // namespace first_impact_tests

}  // namespace
}  // namespace plumb::impact_test
