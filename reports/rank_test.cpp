#include "reports/rank_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <stdexcept>

namespace plumb {
namespace {

constexpr std::size_t exact_up_to = 20;

// In how many of the ways to arrange m a's and n b's does a exceed b in exactly u pairs? Whichever is last of all, an a
// exceeds all n b's, a b none: f(m, n, u) = f(m-1, n, u-n) + f(m, n-1, u).
std::vector<double> ways(std::size_t m, std::size_t n) {
  std::vector<std::vector<double>> of_fewer;  // by number of b's, for one a fewer
  for (std::size_t a = 0; a <= m; ++a) {
    std::vector<std::vector<double>> now(n + 1);
    for (std::size_t b = 0; b <= n; ++b) {
      now[b].assign(a * b + 1, 0);
      if (a == 0 || b == 0) {
        now[b][0] = 1;
        continue;
      }
      for (std::size_t u = 0; u < of_fewer[b].size(); ++u) now[b][u + b] += of_fewer[b][u];
      for (std::size_t u = 0; u < now[b - 1].size(); ++u) now[b][u] += now[b - 1][u];
    }
    of_fewer = std::move(now);
  }
  return of_fewer[n];
}

double exact_p(std::size_t m, std::size_t n, double u) {
  const std::vector<double> all = ways(m, n);
  const auto extreme = static_cast<std::size_t>(std::min(u, static_cast<double>(m * n) - u));
  const double tail = std::accumulate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(extreme) + 1, 0.0);
  return std::min(1.0, 2 * tail / std::accumulate(all.begin(), all.end(), 0.0));
}

// Var U = m n/12 (N + 1 - sum (t^3 - t)/(N (N - 1))), t the sizes of ties, N = m + n.
double normal_p(double m, double n, double u, const std::map<double, int>& counts) {
  const double all = m + n;
  double tied = 0;
  for (const auto& [value, count] : counts) tied += std::pow(count, 3) - count;
  const double variance = m * n / 12 * (all + 1 - tied / (all * (all - 1)));
  if (!(variance > 0)) return 1;
  const double off = std::max(0.0, std::abs(u - m * n / 2) - 0.5);
  return std::erfc(off / std::sqrt(2 * variance));
}

}  // namespace

RankTest rank_test(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("ranks need values on both sides");
  std::map<double, int> counts;
  for (const auto sample : {a, b}) {
    for (const double value : sample) {
      if (std::isnan(value)) throw std::invalid_argument("a value that is not a number has no rank");
      ++counts[value];
    }
  }
  double larger = 0;
  double even = 0;
  for (const double of_a : a) {
    for (const double of_b : b) {
      larger += of_a > of_b;
      even += of_a == of_b;
    }
  }
  const auto m = static_cast<double>(a.size());
  const auto n = static_cast<double>(b.size());
  const double u = larger + even / 2;
  const bool ties = counts.size() < a.size() + b.size();
  const bool exact = !ties && std::max(a.size(), b.size()) <= exact_up_to;
  return {exact ? exact_p(a.size(), b.size(), u) : normal_p(m, n, u, counts), 2 * u / (m * n) - 1};
}

std::vector<bool> significant(std::span<const double> p, double level) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  std::vector<bool> stands(p.size(), false);
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    if (!(p[order[rank]] <= level / static_cast<double>(order.size() - rank))) break;
    stands[order[rank]] = true;
  }
  return stands;
}

}  // namespace plumb
