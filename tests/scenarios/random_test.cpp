#include "scenarios/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb::random_test {
namespace {

// The sequence that other implementations of SplitMix64 give for this seed.
TEST(Random, GeneratesTheSequenceOfSplitMix64) {
  Random random(1234567);
  for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                       4593380528125082431U, 16408922859458223821U}) {
    EXPECT_EQ(random.next(), expected);
  }
}

TEST(Random, IsUniformOverItsRangeAndNeverOutsideIt) {
  Random random(1);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.between(-2, 4);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 4);
    sum += x;
  }
  // The mean of n uniform numbers deviates from the middle with sigma = range/sqrt(12 n): five of those.
  EXPECT_NEAR(sum / 10000, 1, 5 * 6 / std::sqrt(12.0 * 10000));
}

}  // namespace
}  // namespace plumb::random_test
