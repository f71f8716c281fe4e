#include "reports/study/statistics/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "scenarios/random.h"

namespace plumb::ensemble_verdict_test {
namespace {

// Tables: E. S. Pearson, H. O. Hartley, Biometrika Tables for Statisticians, 1966.
TEST(StudentT, HasTheQuantilesOfTheTables) {
  EXPECT_NEAR(student_quantile(0.975, 10), 2.2281, 5e-5);
  EXPECT_NEAR(student_quantile(0.995, 4), 4.6041, 5e-5);
  EXPECT_NEAR(student_quantile(0.9995, 1), 636.62, 5e-3);
  EXPECT_NEAR(student_quantile(0.025, 30), -2.0423, 5e-5);
  EXPECT_NEAR(student_quantile(0.975, 1e6), 1.95996, 1e-5) << "normal in the limit";
}

TEST(ChiSquare, HasTheQuantilesOfTheTables) {
  EXPECT_NEAR(chi_square_quantile(0.95, 10), 18.3070, 5e-5);
  EXPECT_NEAR(chi_square_quantile(0.999, 3), 16.2662, 5e-5);
  EXPECT_NEAR(chi_square_quantile(0.05, 20), 10.8508, 5e-5);
  EXPECT_NEAR(chi_square_share(2 * std::log(2), 2), 0.5, 1e-12) << "exponential for two degrees of freedom";
}

TEST(MeanInterval, TakesTwoValues) {
  EXPECT_THROW(mean_interval(std::vector<double>{1}, 0.05), std::invalid_argument);
  const Estimate found = mean_interval(std::vector<double>{1, 3}, 0.05);
  EXPECT_EQ(found.value, 2);
  EXPECT_EQ(found.error, 1);
  EXPECT_NEAR(found.high, 2 + 12.706, 1e-3);
}

// 2000 samples of six sums of twelve uniform values, normal to a per mille: 100 +- 4 * 9.7 of their intervals miss.
TEST(MeanInterval, MissesTheMeanAsOftenAsItSays) {
  Random random(1);
  int missed = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    std::vector<double> values(6, -6);
    for (double& value : values) {
      for (int i = 0; i < 12; ++i) value += random.between(0, 1);
    }
    const Estimate found = mean_interval(values, 0.05);
    missed += found.low > 0 || found.high < 0;
  }
  EXPECT_NEAR(missed, 100, 39);
}

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
