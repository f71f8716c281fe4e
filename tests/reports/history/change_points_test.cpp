#include "reports/history/change_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/random.h"

namespace plumb::change_points_test {
namespace {

// Nearly normal with variance 1: the sum of twelve uniform numbers (Irwin and Hall).
std::vector<double> noise(std::size_t many, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(many, -6);
  for (double& value : values) {
    for (int i = 0; i < 12; ++i) value += random.between(0, 1);
  }
  return values;
}

std::vector<double> raised(std::vector<double> values, std::size_t from, double by) {
  for (std::size_t i = from; i < values.size(); ++i) values[i] += by;
  return values;
}

TEST(ChangePoints, AreFoundAtAStepOfThreeSigmaInNoise) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto changes = noisy_changes(raised(noise(40, seed), 25, 3));
    if (changes.empty()) continue;
    ++found;
    double nearest = 40;
    for (const ChangePoint& change : changes)
      nearest = std::min(nearest, std::abs(static_cast<double>(change.at) - 25));
    EXPECT_LE(nearest, 2) << "seed " << seed;
    EXPECT_LE(changes.front().p, change_level);
  }
  EXPECT_EQ(found, 20);
}

// Of 300 series that change with a probability of 0.01 each, more than 9 do with a probability of 0.001 and none with
// one of 0.05 (Poisson with mean 3).
TEST(ChangePoints, AreFoundInWhiteNoiseNoMoreOftenThanTheLevelSays) {
  int false_alarms = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) false_alarms += !noisy_changes(noise(24, 1000 + seed), seed).empty();
  EXPECT_LE(false_alarms, 9);
  RecordProperty("false_alarms", false_alarms);
}

TEST(ChangePoints, AreFoundAtTwoSteps) {
  const auto changes = noisy_changes(raised(raised(noise(45, 7), 15, 6), 30, -9));
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].at, 15u);
  EXPECT_EQ(changes[1].at, 30u);
  EXPECT_NEAR(changes[0].before, 0, 1);
  EXPECT_NEAR(changes[0].after, 6, 1);
  EXPECT_EQ(changes[0].after, changes[1].before);
  EXPECT_NEAR(changes[1].after, -3, 1);
}

TEST(ChangePoints, OfExactNumbersAreAllDifferences) {
  const std::vector<double> values{0.1, 0.1, 0.1, 0.1, std::nextafter(0.1, 1)};
  const auto changes = exact_changes(values);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].at, 4u);
  EXPECT_EQ(changes[0].before, 0.1);
  EXPECT_EQ(changes[0].after, values.back());
  EXPECT_EQ(changes[0].p, 0);
}

TEST(ChangePoints, OfTwoExactNumbersAreSeen) {
  const auto changes = exact_changes(std::vector<double>{4.75, 2.29});
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].before, 4.75);
  EXPECT_EQ(changes[0].after, 2.29);
}

TEST(ChangePoints, AreNotFoundInFewValuesThatScatter) {
  EXPECT_TRUE(noisy_changes({}).empty());
  EXPECT_TRUE(noisy_changes(std::vector<double>{1}).empty());
  EXPECT_TRUE(noisy_changes(std::vector<double>{1, 2}).empty());
  EXPECT_TRUE(noisy_changes(std::vector<double>{1, 1.1, 1.2, 9, 9.1}).empty());
}

TEST(ChangePoints, AreTheSameForTheSameSeed) {
  const auto values = raised(noise(30, 3), 12, 2.5);
  const auto once = noisy_changes(values, 5), again = noisy_changes(values, 5);
  ASSERT_FALSE(once.empty());
  ASSERT_EQ(once.size(), again.size());
  EXPECT_EQ(once[0].p, again[0].p);
}

// Shifted and scaled values change at the same indices.
TEST(ChangePoints, DoNotDependOnUnits) {
  const auto values = raised(noise(30, 11), 18, 4);
  std::vector<double> stretched;
  for (const double value : values) stretched.push_back(1e-6 * value + 3);
  const auto a = noisy_changes(values), b = noisy_changes(stretched);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].at, b[i].at);
}

}  // namespace
}  // namespace plumb::change_points_test
