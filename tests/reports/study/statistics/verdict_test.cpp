#include "reports/study/statistics/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/random.h"

namespace plumb::ensemble_verdict_test {
namespace {

// An ensemble of one number, which is between 1 and 2.
Ensemble in_band(double resolution) {
  return {.name = "made", .statistics = {{.name = "number", .low = 1, .high = 2, .resolution = resolution}}};
}

std::vector<EnsembleDraw> about(double mean, double spread) {
  std::vector<EnsembleDraw> draws;
  for (int i = 0; i < 50; ++i) draws.push_back({mean + (i % 2 == 0 ? spread : -spread)});
  return draws;
}

EnsembleFinding judged(const Ensemble& ensemble, const std::vector<EnsembleDraw>& draws) {
  return judge_draws(ensemble, draws, 0.01).front();
}

TEST(EnsembleVerdict, AgreesWhereANarrowIntervalTouchesTheBand) {
  EXPECT_EQ(judged(in_band(0.5), about(1.5, 0.1)).verdict, EnsembleVerdict::agrees);
  EXPECT_EQ(judged(in_band(0.5), about(2.03, 0.1)).verdict, EnsembleVerdict::agrees) << "by chance beside it";
}

TEST(EnsembleVerdict, DiffersWhereTheIntervalIsOutside) {
  const EnsembleFinding found = judged(in_band(0.5), about(2.5, 0.7));
  EXPECT_EQ(found.verdict, EnsembleVerdict::differs);
  EXPECT_NEAR(found.off, 0.5 / 0.1, 1e-9) << "standard errors, .7/sqrt(49) each";
}

TEST(EnsembleVerdict, IsUndecidedWhereTheIntervalIsTooWide) {
  const EnsembleFinding found = judged(in_band(0.1), about(1.5, 0.7));
  EXPECT_EQ(found.verdict, EnsembleVerdict::undecided);
  EXPECT_NEAR(static_cast<double>(found.needed), 50 * std::pow(0.268 / 0.1, 2), 2) << "t = 2.68 of 49";
}

TEST(EnsembleVerdict, DoesNotCountIdealisationsAgainstAnEngine) {
  Ensemble ensemble = in_band(0.5);
  EXPECT_GT(worst_difference(judge_draws(ensemble, about(3, 0.1), 0.01)), 10);
  ensemble.statistics[0].idealisation = true;
  EXPECT_EQ(worst_difference(judge_draws(ensemble, about(3, 0.1), 0.01)), 0);
}

// Pegs to the right of four.
std::vector<EnsembleDraw> pegs(double to_the_right) {
  Random random(3);
  std::vector<EnsembleDraw> draws;
  for (int i = 0; i < 600; ++i) {
    double pegs = -2;
    for (int peg = 0; peg < 4; ++peg) pegs += random.between(0, 1) < to_the_right ? 1 : 0;
    draws.push_back({pegs});
  }
  return draws;
}

TEST(EnsembleVerdict, TestsADistributionByChiSquare) {
  Ensemble ensemble = in_band(10);
  ensemble.distribution = Distribution{.name = "binomial",
                                       .offset = 2,
                                       .shares = {1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16},
                                       .resolution = 0.05};
  EXPECT_EQ(judge_draws(ensemble, pegs(0.5), 0.01)[1].verdict, EnsembleVerdict::agrees);
  EXPECT_EQ(judge_draws(ensemble, pegs(0.6), 0.01)[1].verdict, EnsembleVerdict::differs);
  ensemble.distribution->resolution = 0.001;
  EXPECT_EQ(judge_draws(ensemble, pegs(0.5), 0.01)[1].verdict, EnsembleVerdict::undecided);
}

}  // namespace
}  // namespace plumb::ensemble_verdict_test
