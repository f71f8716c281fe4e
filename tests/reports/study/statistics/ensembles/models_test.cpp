#include "reports/study/statistics/ensembles/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/integrate.h"

namespace plumb::ensembles::models_test {
namespace {

constexpr DominoRow row{.height = 1, .thickness = 0.1, .pitch = 0.5};

// Each impact halves the angular velocity of one that strikes alone, and its fall makes up for it:
// w^2 = w^2/4 + 2 (V(0) - V(b)). The fall is integrated by Runge and Kutta's method instead.
TEST(DominoRow, OfDominoesThatFallAloneRunsAsTheirFallSays) {
  const double factor = 1.5 * 10 / (1 + 0.01);  // of the torque over the moment of inertia: m g/2 over m (h^2 + d^2)/3
  const auto fall = [&](const std::array<double, 2>& y) {
    return std::array<double, 2>{y[1], factor * (std::sin(y[0]) - 0.1 * std::cos(y[0]))};
  };
  const double end = row.strikes_at();
  const double gained = 2 * factor * (1 - std::cos(end) - 0.1 * std::sin(end));
  std::array<double, 2> state{0, std::sqrt(gained / 3)};
  double time = 0;
  for (; state[0] < end; time += 1e-5) state = runge_kutta(state, 1e-5, fall);
  EXPECT_NEAR(row.speed(1), row.pitch / time, 1e-3 * row.speed(1));
}

TEST(DominoRow, RunsFasterTheMoreOfThemPushUpToALimit) {
  for (int pushing = 1; pushing < 8; ++pushing) EXPECT_GT(row.speed(pushing + 1), row.speed(pushing)) << pushing;
  EXPECT_NEAR(row.speed(40), row.speed(20), 1e-4);
}

TEST(DominoRow, RunsAsTheRootOfItsSize) {
  const DominoRow twice{.height = 2, .thickness = 0.2, .pitch = 1};
  EXPECT_NEAR(twice.speed(6) / row.speed(6), std::sqrt(2.0), 1e-6);
}

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
}  // namespace plumb::ensembles::models_test
