#include "reports/study/statistics/ensembles/domino_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/integrate.h"

namespace plumb::ensembles::domino_model_test {
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

}  // namespace
}  // namespace plumb::ensembles::domino_model_test
