#include "reports/timing/side_by_side.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr double noise = 0.01;

// Programs whose times are made up. `slow` says by which factor a case is slower now, in the how-manieth look.
class Fake {
 public:
  using Slow = std::function<double(std::size_t which, std::size_t look)>;
  Fake(unsigned seed, Slow slow) : random_(seed), slow_(std::move(slow)) {}

  std::vector<TimedPair> operator()(std::span<const std::size_t> which, int sittings) {
    std::vector<TimedPair> pairs;
    for (const std::size_t i : which) {
      TimedPair pair{.name = std::to_string(i), .steps = 60, .of = 60};
      if (broken == static_cast<int>(i)) pair.no_result = "refused";
      for (int sitting = 0; sitting < sittings && pair.no_result.empty(); ++sitting) {
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
  double instructions = 1;  // as many times as many now
  bool counts = false;
  int broken = -1;

 private:
  void add(Cost& cost, double time, double count) {
    std::normal_distribution<double> draw(0, noise);
    cost.cpu.push_back(time * std::exp(draw(random_)));
    cost.wall.push_back(cost.cpu.back());
    if (counts) cost.instructions.push_back(count * (1 + 1e-4 * draw(random_)));
  }

  std::mt19937 random_;
  Slow slow_;
};

std::vector<JudgedTime> judge(Fake& fake, std::size_t cases) {
  return judge_times([&](auto which, int sittings) { return fake(which, sittings); }, cases);
}

bool any_slower(const std::vector<JudgedTime>& all) {
  return std::any_of(all.begin(), all.end(), [](const JudgedTime& one) { return one.pace == Pace::slower; });
}

std::vector<Pace> paces(const std::vector<JudgedTime>& all) {
  std::vector<Pace> found;
  for (const JudgedTime& one : all) found.push_back(one.pace);
  return found;
}

TEST(Timing, FivePercentOnEveryCaseAreFound) {
  Fake fake(1, [](auto, auto) { return 1.05; });
  const auto all = judge(fake, 12);
  ASSERT_THAT(all, SizeIs(13));
  EXPECT_TRUE(any_slower(all));
  EXPECT_EQ(all.back().pair.name, "all cases");
  EXPECT_EQ(all.back().pace, Pace::slower);
  EXPECT_NEAR(all.back().time.ratio, 1.05, 0.005);
}

TEST(Timing, FivePercentOnOneCaseAreFoundThere) {
  int found = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    Fake fake(seed, [](std::size_t i, auto) { return i == 3 ? 1.05 : 1; });
    const auto all = judge(fake, 12);
    found += all[3].pace == Pace::slower;
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(i == 3 || all[i].pace != Pace::slower) << seed << " " << i;
  }
  EXPECT_GE(found, 49);
}

TEST(Timing, NoiseIsNot) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Fake fake(seed, [](auto, auto) { return 1.0; });
    EXPECT_FALSE(any_slower(judge(fake, 12))) << seed;
  }
}

TEST(Timing, OnlyWhatIsSuspiciousIsMeasuredAgain) {
  Fake fake(1, [](std::size_t i, auto) { return i == 2 || i == 5 ? 1.1 : 1; });
  judge(fake, 12);
  ASSERT_THAT(fake.looks, SizeIs(2));
  EXPECT_THAT(fake.looks[1], ElementsAre(2, 5));
  Fake calm(1, [](auto, auto) { return 1.0; });
  judge(calm, 12);
  EXPECT_THAT(calm.looks, SizeIs(1));
}

TEST(Timing, WhatDoesNotComeBackIsNotReported) {
  Fake fake(1, [](std::size_t i, std::size_t look) { return i == 2 && look == 0 ? 1.2 : 1; });
  const auto all = judge(fake, 12);
  EXPECT_THAT(fake.looks, SizeIs(2));
  EXPECT_FALSE(any_slower(all));
  EXPECT_TRUE(all[2].measured_again);
  EXPECT_NEAR(all[2].time.ratio, 1, 0.02);  // of the new times alone
  EXPECT_FALSE(all[3].measured_again);
}

TEST(Timing, FasterIsSaidAndFailsNothing) {
  Fake fake(1, [](std::size_t i, auto) { return i == 0 ? 0.8 : 1; });
  const auto all = judge(fake, 3);
  EXPECT_THAT(paces(all), ElementsAre(Pace::faster, Pace::same, Pace::same, Pace::faster));
  EXPECT_FALSE(any_slower(all));
}

TEST(Timing, OneCaseIsNotAllCases) {
  Fake fake(1, [](auto, auto) { return 1.05; });
  EXPECT_THAT(paces(judge(fake, 1)), ElementsAre(Pace::slower));
}

TEST(Timing, WhoRefusesLeavesTheOthersTheirs) {
  Fake fake(1, [](std::size_t i, auto) { return i == 1 ? 1.1 : 1; });
  fake.broken = 2;
  const auto all = judge(fake, 4);
  EXPECT_EQ(all[1].pace, Pace::slower);
  EXPECT_EQ(all[2].pace, Pace::no_result);
  EXPECT_EQ(all[2].pair.no_result, "refused");
  EXPECT_EQ(all[3].pace, Pace::same);
}

TEST(Timing, NobodyWithAResultIsNoMistake) {
  Fake fake(1, [](auto, auto) { return 1.0; });
  fake.broken = 0;
  EXPECT_THAT(paces(judge(fake, 1)), ElementsAre(Pace::no_result));
}

TEST(Timing, MoreInstructionsCountUnlessTheTimeIsLess) {
  Fake more(1, [](auto, auto) { return 1.012; });
  more.counts = true;
  more.instructions = 1.02;
  EXPECT_TRUE(any_slower(judge(more, 3)));
  Fake wider(1, [](auto, auto) { return 0.7; });
  wider.counts = true;
  wider.instructions = 1.02;
  EXPECT_FALSE(any_slower(judge(wider, 3)));
}

TEST(Timing, InstructionsOfOneSideAloneAreNotCompared) {
  TimedPair pair{.name = "one"};
  pair.before = pair.again = {.cpu = {1, 1, 1}, .wall = {1, 1, 1}, .instructions = {1, 1, 1}};
  pair.now = {.cpu = {1, 1, 1}, .wall = {1, 1, 1}};
  const auto all = judge_times([&](auto, auto) { return std::vector{pair}; }, 1);
  EXPECT_EQ(all[0].instructions, std::nullopt);
}

}  // namespace
}  // namespace plumb
