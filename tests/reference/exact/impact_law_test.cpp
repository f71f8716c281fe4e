#include "reference/exact/impact_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

Meeting corner(double friction, double restitution) {
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

After after(const Meeting& m, Vec push) {
  After state{m.velocity + (1 / m.mass) * push, m.spin + cross(m.arm, push) / m.inertia, {}};
  state.point = state.velocity + state.spin * left_of(m.arm);
  return state;
}

// Keller's way: the impact as a process in the normal impulse, bit by bit, friction against the slip of the moment;
// where the approach ends, Poisson's restitution gives the rest as e times the impulse of compression.
Vec integrate(Meeting m) {
  const Vec n = m.normal;
  const Vec t{n.y, -n.x};
  const auto point = [&m] { return m.velocity + m.spin * left_of(m.arm); };
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

TEST(Impulse, AgreesWithKellersProcessWhileTheSlipKeepsItsDirection) {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double mu : {0.0, 0.1, 0.2}) {
      const Meeting meeting = corner(mu, e);
      const std::optional<Vec> push = impulse(meeting);
      ASSERT_TRUE(push);
      ASSERT_GT(after(meeting, *push).point.x, 0) << "this test needs slip that goes on";
      const Vec expected = integrate(meeting);
      EXPECT_NEAR(push->x, expected.x, 1e-9);
      EXPECT_NEAR(push->y, expected.y, 1e-9);
    }
  }
}

TEST(Impulse, WithoutFrictionIsTheTextbooks) {
  const Meeting m = corner(0, 0.5);
  const double un = -5 + 1 * 0.3;
  EXPECT_DOUBLE_EQ(impulse(m)->y, -1.5 * un / (1 / 2.0 + 0.09 / 0.3));
  EXPECT_EQ(impulse(m)->x, 0);
}

TEST(Impulse, TurnsTheNormalSpeedRoundByTheRestitution) {
  for (const double mu : {0.0, 0.2}) {
    const Meeting m = corner(mu, 0.5);
    EXPECT_NEAR(after(m, *impulse(m)).point.y, 0.5 * 4.7, 1e-14);
  }
}

TEST(Impulse, KeepsAngularMomentumAboutThePointAndLosesEnergy) {
  const Meeting m = corner(0.2, 0.5);
  const After then = after(m, *impulse(m));
  const auto about_point = [&m](Vec v, double w) { return m.inertia * w - m.mass * cross(m.arm, v); };
  const auto energy = [&m](Vec v, double w) { return (m.mass * dot(v, v) + m.inertia * w * w) / 2; };
  EXPECT_NEAR(about_point(then.velocity, then.spin), about_point(m.velocity, m.spin), 1e-14);
  EXPECT_LT(energy(then.velocity, then.spin), energy(m.velocity, m.spin));
  const Meeting elastic = corner(0, 1);
  const After back = after(elastic, *impulse(elastic));
  EXPECT_NEAR(energy(back.velocity, back.spin), energy(elastic.velocity, elastic.spin), 1e-14);
}

// A disc: Jn = m (1+e) vn, Jt = min(mu Jn, m vt/3) against vt.
TEST(Impulse, OfADiscGripsOrSlips) {
  Meeting disc{.mass = 2, .inertia = 0.25, .normal = {0, 1}, .arm = {0, -0.5}, .velocity = {3, -4}, .restitution = 0.5};
  for (const double mu : {0.1, 0.9}) {
    disc.friction = mu;
    disc.spin = 0.4;
    const double vt = 3 + 0.4 * 0.5;
    EXPECT_DOUBLE_EQ(impulse(disc)->y, 12);
    EXPECT_DOUBLE_EQ(impulse(disc)->x, -std::min(mu * 12, 2 * vt / 3));
  }
  EXPECT_NEAR(after(disc, *impulse(disc)).point.x, 0, 1e-15);
}

TEST(Impulse, IsTheSameInATurnedFrame) {
  const Meeting m = corner(0.2, 0.5);
  Meeting there = m;
  there.normal = turned(m.normal, 0.7);
  there.arm = turned(m.arm, 0.7);
  there.velocity = turned(m.velocity, 0.7);
  const Vec expected = turned(*impulse(m), 0.7);
  EXPECT_NEAR(impulse(there)->x, expected.x, 1e-13);
  EXPECT_NEAR(impulse(there)->y, expected.y, 1e-13);
}

TEST(Impulse, IsSilentWhereTheLawsDisagree) {
  Meeting stops = corner(0.2, 0.5);  // on its other corner, the push upwards takes the slip away
  stops.arm.x = -0.3;
  EXPECT_FALSE(impulse(stops));
  Meeting leaving = corner(0.2, 0.5);
  leaving.velocity.y = 5;
  EXPECT_FALSE(impulse(leaving));
}

}  // namespace
}  // namespace plumb
