#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::lone_bodies_test {
namespace {

using statement_of::Of;

constexpr double c = 0.8;  // 1/s

// After n steps of h within a second, from 4 m/s.
double damped(double factor, double h) { return 4 * std::pow(factor, 1 / h); }

TEST(LoneBodies, AllowDampingAtTheIntervalThatIsStated) {
  const Of speed{"lone-bodies", {}, "damped", Quantity::vx};
  Stepping stated = statement_of::soft();
  const double off = damped(1 / (1 + c * stated.dt), stated.dt) - 4 * std::exp(-c);
  EXPECT_GT(off, speed.allows(stated)) << "damped once a step, stated as at each sub-step";
  stated.damping_interval = stated.dt;
  EXPECT_LT(off, speed.allows(stated));
}

TEST(LoneBodies, AllowDampingOfTheOrderThatIsStated) {
  const Of speed{"lone-bodies", {}, "damped", Quantity::vx};
  const double exact = 4 * std::exp(-c);
  for (const Stepping& stated : {statement_of::skinned(), statement_of::accurate()}) {
    const double k = c * stated.h;
    const double first = std::abs(damped(1 / (1 + k), stated.h) - exact);
    const double second = std::abs(damped((1 - k / 2) / (1 + k / 2), stated.h) - exact);
    EXPECT_LT(second, speed.allows(stated));
    EXPECT_EQ(first < speed.allows(stated), stated.order == 1);
  }
}

}  // namespace
}  // namespace plumb::lone_bodies_test
