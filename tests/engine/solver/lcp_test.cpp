#include "solver/lcp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace impulse::inline IMPULSE_PRECISION::lcp_test {
namespace {

/// The largest violation of w >= 0, z >= 0 and w z = 0 over all components.
double violation(const std::vector<double>& m, const std::vector<double>& q, const std::vector<double>& z) {
  double worst = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    double w = q[i];
    for (std::size_t j = 0; j < q.size(); ++j) w += m[i * q.size() + j] * z[j];
    worst = std::max({worst, -w, -z[i], std::abs(std::min(w, z[i]))});
  }
  return worst;
}

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

/// A A^T for an n x rank matrix A of numbers in [-1, 1]: positive semidefinite.
std::vector<double> semidefinite(std::mt19937& random, std::size_t n, std::size_t rank) {
  std::vector<double> a(n * rank);
  for (double& x : a) x = between(random, -1, 1);
  std::vector<double> m(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < rank; ++k) m[i * n + j] += a[i * rank + k] * a[j * rank + k];
    }
  }
  return m;
}

TEST(Lcp, ReturnsZeroIfThatIsASolution) {
  const auto z = solve_lcp(std::vector<double>{1, 2, 3, 4}, std::vector<double>{0, 5});
  ASSERT_TRUE(z);
  EXPECT_EQ(*z, (std::vector<double>{0, 0}));
}

// w = (2 1; 1 2) z + (-5, -6) has both w = 0 at z = (4/3, 7/3).
TEST(Lcp, SolvesTwoEquationsByHand) {
  const auto z = solve_lcp(std::vector<double>{2, 1, 1, 2}, std::vector<double>{-5, -6});
  ASSERT_TRUE(z);
  EXPECT_NEAR((*z)[0], 4.0 / 3, 1e-12);
  EXPECT_NEAR((*z)[1], 7.0 / 3, 1e-12);
}

TEST(Lcp, KeepsAPullingVariableAtZero) {
  const auto z = solve_lcp(std::vector<double>{2, 1, 1, 2}, std::vector<double>{-5, 4});
  ASSERT_TRUE(z);
  EXPECT_NEAR((*z)[0], 2.5, 1e-12);
  EXPECT_EQ((*z)[1], 0);
}

// Positive definite problems have one solution (Samelson, Thrall and Wesler 1958), so it is the one they were made
// from.
TEST(Lcp, FindsTheSolutionOfARandomProblem) {
  std::mt19937 random(1);
  for (int problem = 0; problem < 100; ++problem) {
    const std::size_t n = 1 + static_cast<std::size_t>(problem) % 30;
    std::vector<double> m = semidefinite(random, n, n);
    for (std::size_t i = 0; i < n; ++i) m[i * n + i] += 1;
    std::vector<double> known(n, 0);
    std::vector<double> q(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      const double x = between(random, -1, 1);
      (x > 0 ? known[i] : q[i]) = std::abs(x);
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) q[i] -= m[i * n + j] * known[j];
    }
    const auto z = solve_lcp(m, q);
    ASSERT_TRUE(z) << "problem " << problem;
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR((*z)[i], known[i], 1e-9) << "problem " << problem;
  }
}

// The shape of contact with friction: (P E; -E^T 0) with P semidefinite and not of full rank is copositive-plus; q is
// in reach, since P z + q >= 0 for the z that it is made from.
TEST(Lcp, SolvesRandomCopositiveProblemsOfDeficientRank) {
  std::mt19937 random(2);
  for (int problem = 0; problem < 100; ++problem) {
    const std::size_t n = 4 + static_cast<std::size_t>(problem) % 20;
    const std::size_t half = n / 2;
    const std::vector<double> p = semidefinite(random, half, half / 2 + 1);
    std::vector<double> m(n * n, 0);
    for (std::size_t i = 0; i < half; ++i) {
      for (std::size_t j = 0; j < half; ++j) m[i * n + j] = p[i * half + j];
    }
    for (std::size_t i = half; i < n; ++i) {
      const double e = between(random, 0, 1);
      m[(i - half) % half * n + i] = e;
      m[i * n + (i - half) % half] = -e;
    }
    std::vector<double> q(n, 0);
    std::vector<double> feasible(n);
    for (double& x : feasible) x = between(random, 0, 1);
    for (std::size_t i = 0; i < n; ++i) {
      q[i] = between(random, 0, .5);
      for (std::size_t j = 0; j < n; ++j) q[i] -= m[i * n + j] * feasible[j];
    }
    const auto z = solve_lcp(m, q);
    ASSERT_TRUE(z) << "problem " << problem;
    EXPECT_LT(violation(m, q, *z), 1e-9) << "problem " << problem;
  }
}

// All ratios are tied: without the lexicographic rule, pivoting may cycle.
TEST(Lcp, DoesNotCycleOnTies) {
  const std::size_t n = 40;
  std::vector<double> m(n * n, 1);
  const auto z = solve_lcp(m, std::vector<double>(n, -1));
  ASSERT_TRUE(z);
  EXPECT_LT(violation(m, std::vector<double>(n, -1), *z), 1e-12);
}

// Rows that are equal up to rounding: without `noise`, pivots of 1e-7 would decide.
TEST(Lcp, DoesNotPivotOnRoundingErrors) {
  std::mt19937 random(3);
  constexpr double noise = 1e-6;
  for (int problem = 0; problem < 100; ++problem) {
    const std::size_t n = 4 + static_cast<std::size_t>(problem) % 20;
    std::vector<double> m = semidefinite(random, n, n / 2);
    std::vector<double> known(n);
    for (double& x : known) x = between(random, 0, 1);
    std::vector<double> q(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) q[i] -= m[i * n + j] * known[j];
    }
    for (double& x : m) x = static_cast<double>(static_cast<float>(x));
    for (double& x : q) x = static_cast<double>(static_cast<float>(x));
    const auto z = solve_lcp(m, q, noise);
    ASSERT_TRUE(z) << "problem " << problem;
    const auto [least, most] = std::minmax_element(q.begin(), q.end());
    EXPECT_LE(violation(m, q, *z), noise * std::max(-*least, *most)) << "problem " << problem;
  }
}

TEST(Lcp, ReportsThatThereIsNoSolution) {
  EXPECT_FALSE(solve_lcp(std::vector<double>{0}, std::vector<double>{-1}));
  EXPECT_FALSE(solve_lcp(std::vector<double>{1, -1, -1, 1}, std::vector<double>{-1, -1}));
}

TEST(Lcp, RefusesSizesThatDoNotMatch) {
  EXPECT_THROW(solve_lcp(std::vector<double>{1, 2, 3}, std::vector<double>{1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::lcp_test
