#include "broad_phase/pair_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../random_shapes.h"

namespace impulse::inline IMPULSE_PRECISION::pair_order_test {

namespace {

std::vector<Pair> some_pairs(std::size_t count, std::uint32_t proxies) {
  RandomShapes random(7);
  std::vector<Pair> pairs(count);
  for (Pair& pair : pairs) {
    pair.first = static_cast<std::uint32_t>(random.number(0, proxies - 1 + .999));
    pair.second = static_cast<std::uint32_t>(random.number(0, proxies - 1 + .999));
  }
  return pairs;
}

// Some lists have few pairs for the number of proxies, others many.
TEST(PairOrder, IsByFirstThenSecond) {
  PairOrder order;
  for (const std::size_t count : {0U, 1U, 20U, 500U}) {
    std::vector<Pair> pairs = some_pairs(count, 400);
    std::vector<Pair> expected = pairs;
    std::sort(expected.begin(), expected.end());
    order.sort(400, pairs);
    EXPECT_EQ(pairs, expected) << count;
  }
}

TEST(PairOrder, KeepsTheOrderOfEqualKeys) {
  PairOrder order;
  const auto key = [](const Pair& pair) { return pair.second / 10; };
  for (const std::size_t count : {0U, 1U, 2U, 20U, 500U}) {
    std::vector<Pair> pairs = some_pairs(count, 400);
    std::vector<Pair> expected = pairs;
    std::stable_sort(expected.begin(), expected.end(), [&](const Pair& a, const Pair& b) { return key(a) < key(b); });
    order.stable_sort(40, pairs, key);
    EXPECT_EQ(pairs, expected) << count;
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::pair_order_test
