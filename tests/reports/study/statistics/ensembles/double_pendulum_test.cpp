#include "reports/study/statistics/ensembles/double_pendulum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::ensembles::double_pendulum_test {
namespace {

TEST(DoublePendulumModel, KeepsItsEnergy) {
  const DoublePendulum::State start = DoublePendulum::drawn(1);
  const double energy = DoublePendulum::energy(start);
  EXPECT_NEAR(energy, DoublePendulum::energy({2.2, 2.2, 0, 0}), 1e-5 * energy) << "all draws have this one";
  EXPECT_NEAR(DoublePendulum::energy(DoublePendulum::after(start, 30)), energy, 1e-6 * energy);
  EXPECT_NE(DoublePendulum::drawn(2), start);
}

// For thin rods the slow mode has w^2 = (3 - 6/sqrt 7) g/l (Landau and Lifshitz, Mechanics, by the same method as 5.1);
// the angles are as 1 to (2 sqrt 7 - 1)/3. A thickness of a tenth makes it slower by .2 %.
TEST(DoublePendulumModel, SwingsInItsSlowMode) {
  const double w = std::sqrt((3 - 6 / std::sqrt(7.0)) * 10);
  const double angle = 1e-3;
  const double other = angle * (2 * std::sqrt(7.0) - 1) / 3;
  const DoublePendulum::State half = DoublePendulum::after({angle, other, 0, 0}, std::numbers::pi / w);
  EXPECT_NEAR(half[0], -angle, 2e-5);
  EXPECT_NEAR(half[1], -other, 2e-5);
}

// Benettin's method: the distance of two motions, made small again every second. Three motions of 200 s, +- .05 each.
TEST(DoublePendulumModel, HasTheLyapunovExponentThatTheEnsembleExpects) {
  constexpr double apart = 1e-7;
  constexpr int seconds = 200;
  double sum = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    DoublePendulum::State p = DoublePendulum::drawn(seed);
    DoublePendulum::State q = p;
    q[0] += apart;
    for (int i = 0; i < seconds; ++i) {
      p = DoublePendulum::after(p, 1);
      q = DoublePendulum::after(q, 1);
      const double grown = distance(p, q) / apart;
      sum += std::log(grown) / (3 * seconds);
      for (std::size_t k = 0; k < 4; ++k) q[k] = p[k] + (q[k] - p[k]) / grown;
    }
  }
  EXPECT_NEAR(sum, 1.46, 0.1);
}

}  // namespace
}  // namespace plumb::ensembles::double_pendulum_test
