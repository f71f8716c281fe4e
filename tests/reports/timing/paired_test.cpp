#include "reports/timing/paired.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

namespace plumb::paired_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

// Times with lognormal noise.
std::vector<double> noisy(double time, double spread, int rounds, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> draw(0, spread);
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) times.push_back(time * std::exp(draw(random)));
  return times;
}

// Rounds of the program before, now and before again. All three vary together by tens of percent, as the machine does.
TimedPair noisy_pair(double now, double spread, int count, unsigned seed) {
  TimedPair pair;
  const std::vector<double> common = noisy(100, 0.2, count, seed + 100000);
  pair.before.cpu = pair.again.cpu = pair.now.cpu = common;
  unsigned another = 3 * seed;
  for (std::vector<double>* side : {&pair.before.cpu, &pair.now.cpu, &pair.again.cpu}) {
    const std::vector<double> own = noisy(side == &pair.now.cpu ? now : 1, spread, count, another++);
    for (std::size_t i = 0; i < own.size(); ++i) (*side)[i] *= own[i];
  }
  return pair;
}

Shift shift(double now, double spread, int count, unsigned seed) {
  return shift_of(noisy_pair(now, spread, count, seed), &StepCosts::cpu);
}

bool is_slower(const Shift& found, double level = 0.01) { return slower(std::vector{found}, level, 0.025).front(); }

TEST(TimingShift, IsTheMedianOfAllQuotients) {
  TimedPair pair;
  pair.before.cpu = {1, 10, 100};
  pair.again.cpu = {1, 20, 400};  // 1, 2, 4 of the one before
  pair.now.cpu = {2, 40, 800};    // 2, 4, 8
  const Shift found = shift_of(pair, &StepCosts::cpu);
  EXPECT_DOUBLE_EQ(found.ratio, 2);
  EXPECT_NEAR(found.effect, 5.0 / 9, 1e-12);  // of nine pairs six are larger, two even, one smaller
}

TEST(TimingShift, HardlyMovesWithOneOutlier) {
  TimedPair pair = noisy_pair(1.05, 0.001, 12, 1);
  pair.now.cpu[3] = 1e6;
  EXPECT_NEAR(shift_of(pair, &StepCosts::cpu).ratio, 1.05, 0.002);
}

TEST(TimingShift, FindsFivePercentInNoiseOfOnePercent) {
  int found = 0;
  for (unsigned seed = 0; seed < 100; ++seed) found += is_slower(shift(1.05, 0.01, 12, seed));
  EXPECT_GE(found, 99);
}

TEST(TimingShift, FindsNothingInNoiseAlone) {
  int found = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) found += is_slower(shift(1, 0.02, 12, seed));
  EXPECT_LE(found, 5);  // of 1000 at the level 0.01, one side of two
}

TEST(TimingShift, ThatIsSignificantButSmallIsNotSlower) {
  const Shift sure = shift(1.01, 0.0001, 12, 1);
  EXPECT_LT(sure.p, 1e-5);
  EXPECT_FALSE(is_slower(sure));
  EXPECT_THAT(slower(std::vector{sure}, 0.01, 0.005), ElementsAre(true));
}

TEST(TimingShift, NeedsMoreSignificanceAmongMoreCases) {
  // p = 0.009 is significant among 5 at the level 0.05 (0.01 each), but not among 6 (0.0083).
  const Shift hint{.ratio = 1.1, .p = 0.009, .effect = 0.8};
  std::vector<Shift> all(5);
  all[2] = hint;
  EXPECT_THAT(slower(all, 0.05, 0.025), ElementsAre(false, false, true, false, false));
  all.emplace_back();
  EXPECT_THAT(slower(all, 0.05, 0.025), testing::Each(false));
}

TEST(TimingShift, BelowOneIsNotSlower) { EXPECT_FALSE(is_slower(shift(0.9, 0.01, 12, 1))); }

TEST(TimingShift, RefusesMissingAndInvalidTimes) {
  TimedPair pair;
  EXPECT_THROW(shift_of(pair, &StepCosts::cpu), std::invalid_argument);
  pair.before.cpu = pair.again.cpu = {1, 2};
  pair.now.cpu = {1, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(shift_of(pair, &StepCosts::cpu), std::invalid_argument);
}

TEST(TimingShift, OfAllCasesIsThatOfTheGeometricMeanOfThoseWithAResult) {
  std::vector<TimedPair> pairs(3);
  pairs[0].now.cpu = {1, 4};
  pairs[1].no_result = "refused";
  pairs[2].now.cpu = {4, 9};
  EXPECT_THAT(overall(pairs).now.cpu, testing::Pointwise(testing::DoubleNear(1e-12), {2.0, 6.0}));
  EXPECT_TRUE(overall(pairs).now.instructions.empty());
}

constexpr double noise = 0.01;

// Programs whose times are made up. `slow` gives the factor by which a case is slower now; `look` is 0 the first time
// that cases are measured, 1 the second time.
class Fake {
 public:
  using Slow = std::function<double(std::size_t which, std::size_t look)>;
  Fake(unsigned seed, Slow slow) : random_(seed), slow_(std::move(slow)) {}

  std::vector<TimedPair> operator()(std::span<const std::size_t> which, int rounds) {
    std::vector<TimedPair> pairs;
    for (const std::size_t i : which) {
      TimedPair pair{.name = std::to_string(i), .steps = 60, .of = 60};
      if (broken == static_cast<int>(i)) pair.no_result = "refused";
      for (int round = 0; round < rounds && pair.no_result.empty(); ++round) {
        add(pair.before, 1e-6, 1000);
        add(pair.again, 1e-6, 1000);
        add(pair.now, 1e-6 * slow_(i, looks.size()), 1000 * instructions);
      }
      pairs.push_back(std::move(pair));
    }
    looks.push_back({which.begin(), which.end()});
    return pairs;
  }

  std::vector<std::vector<std::size_t>> looks;
  double instructions = 1;  // now, relative to before
  bool counts = false;
  int broken = -1;

 private:
  void add(StepCosts& cost, double time, double count) {
    std::normal_distribution<double> draw(0, noise);
    cost.cpu.push_back(time * std::exp(draw(random_)));
    cost.wall.push_back(cost.cpu.back());
    if (counts) cost.instructions.push_back(count * (1 + 1e-4 * draw(random_)));
  }

  std::mt19937 random_;
  Slow slow_;
};

std::vector<JudgedTime> judge(Fake& fake, std::size_t cases) {
  return judge_times([&](auto which, int rounds) { return fake(which, rounds); }, cases);
}

bool any_slower(const std::vector<JudgedTime>& all) {
  return std::any_of(all.begin(), all.end(), [](const JudgedTime& one) { return one.change == TimeChange::slower; });
}

std::vector<TimeChange> changes(const std::vector<JudgedTime>& all) {
  std::vector<TimeChange> found;
  for (const JudgedTime& one : all) found.push_back(one.change);
  return found;
}

TEST(JudgeTimes, FindsFivePercentOnEveryCase) {
  Fake fake(1, [](auto, auto) { return 1.05; });
  const auto all = judge(fake, 12);
  ASSERT_THAT(all, SizeIs(13));
  EXPECT_TRUE(any_slower(all));
  EXPECT_EQ(all.back().pair.name, "all cases");
  EXPECT_EQ(all.back().change, TimeChange::slower);
  EXPECT_NEAR(all.back().time.ratio, 1.05, 0.005);
}

TEST(JudgeTimes, FindsFivePercentOnOneCaseThere) {
  int found = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    Fake fake(seed, [](std::size_t i, auto) { return i == 3 ? 1.05 : 1; });
    const auto all = judge(fake, 12);
    found += all[3].change == TimeChange::slower;
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_TRUE(i == 3 || all[i].change != TimeChange::slower) << seed << " " << i;
  }
  EXPECT_GE(found, 49);
}

TEST(JudgeTimes, FindsNothingInNoise) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Fake fake(seed, [](auto, auto) { return 1.0; });
    EXPECT_FALSE(any_slower(judge(fake, 12))) << seed;
  }
}

TEST(JudgeTimes, MeasuresOnlySuspiciousCasesAgain) {
  Fake fake(1, [](std::size_t i, auto) { return i == 2 || i == 5 ? 1.1 : 1; });
  judge(fake, 12);
  ASSERT_THAT(fake.looks, SizeIs(2));
  EXPECT_THAT(fake.looks[1], ElementsAre(2, 5));
  Fake calm(1, [](auto, auto) { return 1.0; });
  judge(calm, 12);
  EXPECT_THAT(calm.looks, SizeIs(1));
}

TEST(JudgeTimes, DoesNotReportASlowdownThatDoesNotRecur) {
  Fake fake(1, [](std::size_t i, std::size_t look) { return i == 2 && look == 0 ? 1.2 : 1; });
  const auto all = judge(fake, 12);
  EXPECT_THAT(fake.looks, SizeIs(2));
  EXPECT_FALSE(any_slower(all));
  EXPECT_TRUE(all[2].measured_again);
  EXPECT_NEAR(all[2].time.ratio, 1, 0.02);  // of the new times alone
  EXPECT_FALSE(all[3].measured_again);
}

TEST(JudgeTimes, ReportsFasterCasesAndFailsNothing) {
  Fake fake(1, [](std::size_t i, auto) { return i == 0 ? 0.8 : 1; });
  const auto all = judge(fake, 3);
  EXPECT_THAT(changes(all), ElementsAre(TimeChange::faster, TimeChange::same, TimeChange::same, TimeChange::faster));
  EXPECT_FALSE(any_slower(all));
}

TEST(JudgeTimes, HasNoAllCasesForASingleCase) {
  Fake fake(1, [](auto, auto) { return 1.05; });
  EXPECT_THAT(changes(judge(fake, 1)), ElementsAre(TimeChange::slower));
}

TEST(JudgeTimes, KeepsTheOtherCasesIfOneIsRefused) {
  Fake fake(1, [](std::size_t i, auto) { return i == 1 ? 1.1 : 1; });
  fake.broken = 2;
  const auto all = judge(fake, 4);
  EXPECT_EQ(all[1].change, TimeChange::slower);
  EXPECT_EQ(all[2].change, TimeChange::no_result);
  EXPECT_EQ(all[2].pair.no_result, "refused");
  EXPECT_EQ(all[3].change, TimeChange::same);
}

TEST(JudgeTimes, AcceptsThatNoCaseHasAResult) {
  Fake fake(1, [](auto, auto) { return 1.0; });
  fake.broken = 0;
  EXPECT_THAT(changes(judge(fake, 1)), ElementsAre(TimeChange::no_result));
}

TEST(JudgeTimes, CountsMoreInstructionsUnlessTheTimeIsLess) {
  Fake more(1, [](auto, auto) { return 1.012; });
  more.counts = true;
  more.instructions = 1.02;
  EXPECT_TRUE(any_slower(judge(more, 3)));
  Fake wider(1, [](auto, auto) { return 0.7; });
  wider.counts = true;
  wider.instructions = 1.02;
  EXPECT_FALSE(any_slower(judge(wider, 3)));
}

TEST(JudgeTimes, DoesNotCompareInstructionsOfOneSideOnly) {
  TimedPair pair{.name = "one"};
  pair.before = pair.again = {.cpu = {1, 1, 1}, .wall = {1, 1, 1}, .instructions = {1, 1, 1}};
  pair.now = {.cpu = {1, 1, 1}, .wall = {1, 1, 1}};
  const auto all = judge_times([&](auto, auto) { return std::vector{pair}; }, 1);
  EXPECT_EQ(all[0].instructions, std::nullopt);
}

}  // namespace
}  // namespace plumb::paired_test
