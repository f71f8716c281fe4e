#include "reports/timing/judge_times.h"

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

// Sittings of the program before, now and before again; what they have in common changes by tens of percent.
TimedPair sittings(double now, double noise, int count, unsigned seed) {
  TimedPair pair;
  const std::vector<double> common = noisy(100, 0.2, count, seed + 100000);
  pair.before.cpu = pair.again.cpu = pair.now.cpu = common;
  unsigned another = 3 * seed;
  for (std::vector<double>* side : {&pair.before.cpu, &pair.now.cpu, &pair.again.cpu}) {
    const std::vector<double> own = noisy(side == &pair.now.cpu ? now : 1, noise, count, another++);
    for (std::size_t i = 0; i < own.size(); ++i) (*side)[i] *= own[i];
  }
  return pair;
}

Shift shift(double now, double noise, int count, unsigned seed) {
  return shift_of(sittings(now, noise, count, seed), &Cost::cpu);
}

bool is_slower(const Shift& shift, double level = 0.01) { return slower(std::vector{shift}, level, 0.025).front(); }

TEST(TimingJudge, TellsTheMedianOfAllQuotients) {
  TimedPair pair;
  pair.before.cpu = {1, 10, 100};
  pair.again.cpu = {1, 20, 400};  // 1, 2, 4 of the one before
  pair.now.cpu = {2, 40, 800};    // 2, 4, 8
  const Shift found = shift_of(pair, &Cost::cpu);
  EXPECT_DOUBLE_EQ(found.ratio, 2);
  EXPECT_NEAR(found.effect, 5.0 / 9, 1e-12);  // of nine pairs six are larger, two even, one smaller
}

TEST(TimingJudge, OneWildSittingHardlyMovesTheRatio) {
  TimedPair pair = sittings(1.05, 0.001, 12, 1);
  pair.now.cpu[3] = 1e6;
  EXPECT_NEAR(shift_of(pair, &Cost::cpu).ratio, 1.05, 0.002);
}

TEST(TimingJudge, FindsFivePercentInOnePercentOfNoise) {
  int found = 0;
  for (unsigned seed = 0; seed < 100; ++seed) found += is_slower(shift(1.05, 0.01, 12, seed));
  EXPECT_GE(found, 99);
}

TEST(TimingJudge, FindsNothingInNoiseAlone) {
  int found = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) found += is_slower(shift(1, 0.02, 12, seed));
  EXPECT_LE(found, 5);  // of 1000 at the level 0.01, one side of two
}

TEST(TimingJudge, WhatIsSureButSmallIsNotSlower) {
  const Shift sure = shift(1.01, 0.0001, 12, 1);
  EXPECT_LT(sure.p, 1e-5);
  EXPECT_FALSE(is_slower(sure));
  EXPECT_THAT(slower(std::vector{sure}, 0.01, 0.005), ElementsAre(true));
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

TEST(TimingJudge, FasterIsNotSlower) { EXPECT_FALSE(is_slower(shift(0.9, 0.01, 12, 1))); }

TEST(TimingJudge, RefusesTimesThatAreNone) {
  TimedPair pair;
  EXPECT_THROW(shift_of(pair, &Cost::cpu), std::invalid_argument);
  pair.before.cpu = pair.again.cpu = {1, 2};
  pair.now.cpu = {1, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(shift_of(pair, &Cost::cpu), std::invalid_argument);
}

TEST(TimingJudge, TogetherIsTheGeometricMeanOfThoseWithAResult) {
  std::vector<TimedPair> pairs(3);
  pairs[0].now.cpu = {1, 4};
  pairs[1].no_result = "refused";
  pairs[2].now.cpu = {4, 9};
  EXPECT_THAT(overall(pairs).now.cpu, testing::Pointwise(testing::DoubleNear(1e-12), {2.0, 6.0}));
  EXPECT_TRUE(overall(pairs).now.instructions.empty());
}

}  // namespace
}  // namespace plumb
