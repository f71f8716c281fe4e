#include "reports/gate/timing_judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace plumb {
namespace {

using testing::ElementsAre;

// Lognormal noise about a time, as sittings show it: some percent.
std::vector<double> noisy(double time, double noise, int sittings, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> draw(0, noise);
  std::vector<double> times;
  for (int i = 0; i < sittings; ++i) times.push_back(time * std::exp(draw(random)));
  return times;
}

TEST(TimingJudge, TellsTheMedianRatioOfAllPairs) {
  const Shift shift = shift_of(std::vector{1.0, 2.0, 4.0}, std::vector{2.0, 4.0, 8.0});
  EXPECT_DOUBLE_EQ(shift.ratio, 2);
  EXPECT_NEAR(shift.effect, 5.0 / 9, 1e-12);  // six pairs larger, two even, one smaller
}

TEST(TimingJudge, OneWildSittingHardlyMovesTheRatio) {
  std::vector<double> now = noisy(105, 0.001, 9, 1);
  now.push_back(1e6);
  EXPECT_NEAR(shift_of(noisy(100, 0.001, 10, 2), now).ratio, 1.05, 0.002);
}

TEST(TimingJudge, FindsFivePercentInOnePercentOfNoise) {
  int found = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Shift shift = shift_of(noisy(100, 0.01, 16, seed), noisy(105, 0.01, 16, seed + 1000));
    found += slower(std::vector{shift}, 0.01, 0.025).front();
  }
  EXPECT_GE(found, 99);
}

TEST(TimingJudge, FindsNothingInNoiseAlone) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Shift shift = shift_of(noisy(100, 0.02, 16, seed), noisy(100, 0.02, 16, seed + 1000));
    EXPECT_FALSE(slower(std::vector{shift}, 0.01, 0.025).front()) << seed;
  }
}

TEST(TimingJudge, WhatIsSureButSmallIsNotSlower) {
  const Shift shift = shift_of(noisy(100, 0.0001, 16, 1), noisy(101, 0.0001, 16, 2));
  EXPECT_LT(shift.p, 1e-6);
  EXPECT_THAT(slower(std::vector{shift}, 0.01, 0.025), ElementsAre(false));
  EXPECT_THAT(slower(std::vector{shift}, 0.01, 0.005), ElementsAre(true));
}

TEST(TimingJudge, ManyCasesAskForMoreOfEach) {
  // p = 0.01 stands among 5 at the level 0.05, and no more among 6.
  const Shift hint{.ratio = 1.1, .p = 0.01, .effect = 0.8};
  std::vector<Shift> all(5);
  all[2] = hint;
  EXPECT_THAT(slower(all, 0.05, 0.025), ElementsAre(false, false, true, false, false));
  all.emplace_back();
  EXPECT_THAT(slower(all, 0.05, 0.025), testing::Each(false));
}

TEST(TimingJudge, FasterIsNotSlower) {
  EXPECT_THAT(slower(std::vector{shift_of(noisy(100, 0.01, 16, 1), noisy(90, 0.01, 16, 2))}, 0.05, 0.025),
              ElementsAre(false));
}

TEST(TimingJudge, RefusesTimesThatAreNone) {
  EXPECT_THROW(shift_of({}, std::vector{1.0}), std::invalid_argument);
  EXPECT_THROW(shift_of(std::vector{1.0}, std::vector{std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
}

TEST(TimingJudge, TogetherIsTheGeometricMeanOfThoseWithAResult) {
  std::vector<TimedPair> pairs(3);
  pairs[0].before.cpu = {1, 4};
  pairs[1].no_result = "refused";
  pairs[2].before.cpu = {4, 9};
  EXPECT_THAT(overall(pairs, &TimedPair::before).cpu, testing::Pointwise(testing::DoubleNear(1e-12), {2.0, 6.0}));
  EXPECT_TRUE(overall(pairs, &TimedPair::before).instructions.empty());
}

}  // namespace
}  // namespace plumb
