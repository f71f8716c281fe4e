#include "solver/joint_system.h"

#include <gtest/gtest.h>

#include <vector>

namespace impulse::inline IMPULSE_PRECISION::joint_system_test {
namespace {

constexpr std::uint64_t unlimited = 1000000000;

/// Rows that begin this many columns before the diagonal, or at the first column.
std::vector<std::size_t> band(std::size_t rows, std::size_t width) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < rows; ++i) first.push_back(i > width ? i - width : 0);
  return first;
}

// Row i of a full matrix: 1 + 2 + ... + (i + 1) multiplications; n (n + 1) (n + 2)/6 in all.
TEST(FactoringCost, OfAFullMatrixIsASixthOfItsCube) {
  EXPECT_EQ(factoring_cost(band(3, 3), unlimited), 3U * 4 * 5 / 6);
  EXPECT_EQ(factoring_cost(band(100, 100), unlimited), 100U * 101 * 102 / 6);
}

TEST(FactoringCost, OfAChainIsProportionalToItsLength) {
  const std::uint64_t one = factoring_cost(band(1000, 3), unlimited);
  const std::uint64_t two = factoring_cost(band(2000, 3), unlimited);
  EXPECT_EQ(two - one, 1000U * (1 + 2 + 3 + 4));
}

// The last row is long, but shares next to nothing with each of the others.
TEST(FactoringCost, OfARingIsThatOfItsChainAndOneLongRow) {
  std::vector<std::size_t> ring = band(1000, 1);
  const std::uint64_t chain = factoring_cost(ring, unlimited);
  ring.push_back(0);
  EXPECT_EQ(factoring_cost(ring, unlimited), chain + 1 + 2 * 999 + 1001);
}

TEST(FactoringCost, IsCountedOnlyUpToTheLimit) {
  const std::uint64_t counted = factoring_cost(band(100000, 400), 1000);
  EXPECT_GT(counted, 1000U);
  EXPECT_LE(counted, 1000U + 401);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::joint_system_test
