#include "reports/timing/repetitions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace plumb::repetitions_test {
namespace {

using testing::ElementsAre;

TEST(Rounds, BeginWithAnotherContestantEachTime) {
  std::string order;
  const auto note = [&](std::size_t contestant) { order += static_cast<char>('a' + contestant); };
  for (std::size_t round = 0; round < 4; ++round) play_round(round, 3, note);
  EXPECT_EQ(order, "abcbcacababc");
}

TEST(Rounds, EndWhenNobodyNeedsMoreRepetitions) {
  std::string order;
  std::vector<int> wanted{1, 3};
  repeat_until_settled(2, [&](std::size_t contestant) {
    if (wanted[contestant] == 0) return false;
    --wanted[contestant];
    order += static_cast<char>('a' + contestant);
    return true;
  });
  EXPECT_EQ(order, "abbb");
}

constexpr RepetitionRule rule{
    .fewest = 5, .most = 7, .budget = 1, .wide = 0.1, .slow = 0.1, .fewest_if_slow = 3, .long_enough = 2};

// The number of counted repetitions after which a timing is settled, if they take these times in turn.
std::size_t settled_after(double a, double b, double spent) {
  Repetitions all(rule);
  for (bool first = true; !all.settled(); first = !first) all.add(first ? a : b, spent);
  return all.counted().size();
}

TEST(Repetitions, DoNotCountTheWarmUp) {
  Repetitions all(rule);
  EXPECT_TRUE(all.counted().empty());
  for (const double time : {9e-3, 1e-3, 2e-3}) all.add(time);
  EXPECT_THAT(all.counted(), ElementsAre(1e-3, 2e-3));
}

TEST(Repetitions, CountTheFirstIfItIsSlow) {
  Repetitions all(rule);
  all.add(0.2);
  EXPECT_THAT(all.counted(), ElementsAre(0.2));
}

TEST(Repetitions, AreFewerForWhatIsSlow) {
  EXPECT_EQ(settled_after(1e-3, 1e-3, 1e-3), 5U);
  EXPECT_EQ(settled_after(0.2, 0.2, 0.2), 3U);
  EXPECT_EQ(settled_after(1e-3, 1e-3, 0.2), 3U);  // what is not timed counts as time spent
}

TEST(Repetitions, AreOneIfThatIsLongEnough) {
  EXPECT_EQ(settled_after(2, 3, 2), 1U);
  EXPECT_EQ(settled_after(1.9, 3, 1.9), 3U);
}

TEST(Repetitions, AreMoreWhileTheyVaryUpToTheBudget) {
  EXPECT_EQ(settled_after(1e-3, 2e-3, 2e-3), 7U);
  EXPECT_EQ(settled_after(0.24, 0.48, 0.3), 4U);
}

TEST(Repetitions, HaveAMedianAndAreWideIfTheyVary) {
  Repetitions all(rule);
  for (const double time : {0.0, 1.0, 2.0, 3.0}) all.add(time, 0.01);
  EXPECT_DOUBLE_EQ(all.spread().low, 1.5);
  EXPECT_DOUBLE_EQ(all.spread().median, 2);
  EXPECT_TRUE(all.wide());
}

TEST(Ratios, AreElementByElement) {
  EXPECT_THAT(ratios(std::vector{6.0, 8.0}, std::vector{2.0, 4.0}), ElementsAre(3, 2));
  EXPECT_THROW(ratios(std::vector{6.0}, std::vector{2.0, 4.0}), std::invalid_argument);
}

TEST(Ratios, OfTimesAreTakenInAlternatingPairsUntilDecided) {
  std::string order;
  const auto a = [&] {
    order += 'a';
    return 6.0;
  };
  const auto b = [&] {
    order += 'b';
    return 2.0;
  };
  const auto always = [](const Quartiles&) { return true; };
  const auto never = [](const Quartiles&) { return false; };
  EXPECT_DOUBLE_EQ(time_ratio(a, b, 3, 5, always).median, 3);
  EXPECT_EQ(order, "abbaab");
  order.clear();
  time_ratio(a, b, 3, 5, never);
  EXPECT_EQ(order.size(), 10U);
}

}  // namespace
}  // namespace plumb::repetitions_test
