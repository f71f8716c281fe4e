#include "reports/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <stdexcept>

namespace plumb {
namespace {

constexpr std::size_t largest_exact_sample = 20;

// The number of orders of m a's and n b's in which a exceeds b in exactly u pairs, by u. If the largest value is an a,
// it exceeds all n b's; if it is a b, it adds nothing: f(m, n, u) = f(m-1, n, u-n) + f(m, n-1, u).
std::vector<double> count_orders(std::size_t m, std::size_t n) {
  std::vector<std::vector<double>> with_one_a_less;  // by the number of b's
  for (std::size_t a = 0; a <= m; ++a) {
    std::vector<std::vector<double>> now(n + 1);
    for (std::size_t b = 0; b <= n; ++b) {
      now[b].assign(a * b + 1, 0);
      if (a == 0 || b == 0) {
        now[b][0] = 1;
        continue;
      }
      for (std::size_t u = 0; u < with_one_a_less[b].size(); ++u) now[b][u + b] += with_one_a_less[b][u];
      for (std::size_t u = 0; u < now[b - 1].size(); ++u) now[b][u] += now[b - 1][u];
    }
    with_one_a_less = std::move(now);
  }
  return with_one_a_less[n];
}

double exact_p(std::size_t m, std::size_t n, double u) {
  const std::vector<double> all = count_orders(m, n);
  const auto extreme = static_cast<std::size_t>(std::min(u, static_cast<double>(m * n) - u));
  const double tail = std::accumulate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(extreme) + 1, 0.0);
  return std::min(1.0, 2 * tail / std::accumulate(all.begin(), all.end(), 0.0));
}

// Var U = m n/12 (N + 1 - sum (t^3 - t)/(N (N - 1))), t the sizes of the ties, N = m + n.
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

Quartiles quartiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(position));
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (position - std::floor(position)) * (values[above] - values[below]);
  };
  return {at(0.25), at(0.5), at(0.75)};
}

RankTest rank_test(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("a rank test needs values on both sides");
  std::map<double, int> counts;
  for (const auto sample : {a, b}) {
    for (const double value : sample) {
      if (std::isnan(value)) throw std::invalid_argument("a rank test cannot rank NaN");
      ++counts[value];
    }
  }
  double larger = 0;
  double equal = 0;
  for (const double of_a : a) {
    for (const double of_b : b) {
      larger += of_a > of_b;
      equal += of_a == of_b;
    }
  }
  const auto m = static_cast<double>(a.size());
  const auto n = static_cast<double>(b.size());
  const double u = larger + equal / 2;
  const bool ties = counts.size() < a.size() + b.size();
  const bool exact = !ties && std::max(a.size(), b.size()) <= largest_exact_sample;
  return {exact ? exact_p(a.size(), b.size(), u) : normal_p(m, n, u, counts), 2 * u / (m * n) - 1};
}

std::vector<bool> significant(std::span<const double> p, double level) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  std::vector<bool> rejected(p.size(), false);
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    if (!(p[order[rank]] <= level / static_cast<double>(order.size() - rank))) break;
    rejected[order[rank]] = true;
  }
  return rejected;
}

}  // namespace plumb
