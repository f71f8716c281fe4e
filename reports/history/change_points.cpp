#include "reports/history/change_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "scenarios/random.h"

namespace plumb {
namespace {

constexpr int permutations = 499;  // the smallest p is 1/500

struct Split {
  std::size_t at = 0;
  double distance = -std::numeric_limits<double>::infinity();
};

// The values x are split into the first m and the n that follow, up to an end that may lie before the last value,
// because further changes would blur this one. With sums over pairs, W within a side and B between both:
//
//   Q = m n/(m + n) (2 B/(m n) - W_m/(m (m-1)/2) - W_n/(n (n-1)/2))
//
// B is the sum within both sides together minus the sums within each.
Split best_split(std::span<const double> x) {
  const std::size_t size = x.size();
  Split best;
  if (size < 2 * least_values) return best;
  std::vector<double> sums((size + 1) * (size + 1));
  const auto within = [&](std::size_t from, std::size_t to) -> double& { return sums[from * (size + 1) + to]; };
  for (std::size_t to = 1; to < size; ++to) {
    double of_last = 0;
    for (std::size_t from = to; from-- > 0;) {
      of_last += std::abs(x[from] - x[to]);
      within(from, to + 1) = within(from, to) + of_last;
    }
  }
  for (std::size_t at = least_values; at + least_values <= size; ++at) {
    for (std::size_t end = at + least_values; end <= size; ++end) {
      const auto m = static_cast<double>(at), n = static_cast<double>(end - at);
      const double first = within(0, at), second = within(at, end);
      const double between = within(0, end) - first - second;
      const double distance =
          m * n / (m + n) * (2 * between / (m * n) - 2 * first / (m * (m - 1)) - 2 * second / (n * (n - 1)));
      if (distance > best.distance) best = {at, distance};
    }
  }
  return best;
}

// The Fisher-Yates shuffle.
void shuffle(std::span<double> values, Random& random) {
  for (std::size_t left = values.size(); left > 1; --left) {
    std::swap(values[left - 1], values[static_cast<std::size_t>(random.next() % left)]);
  }
}

// The p-value of the best split of all segments: how often permuting the values of each segment gives a split with as
// large a distance. Returns nullopt as soon as it exceeds the level.
std::optional<double> p_value(std::span<const double> values, const std::vector<std::size_t>& bounds, double distance,
                              Random& random) {
  const int most = static_cast<int>(change_level * (permutations + 1));
  std::vector<double> mixed(values.begin(), values.end());
  int as_far = 1;  // the actual order
  for (int order = 0; order < permutations; ++order) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const auto segment = std::span(mixed).subspan(bounds[i], bounds[i + 1] - bounds[i]);
      shuffle(segment, random);
      farthest = std::max(farthest, best_split(segment).distance);
    }
    // The same two sides in another order have the same distance except for the rounding of sums of n^2/2 terms.
    const double size = static_cast<double>(values.size());
    if (farthest >= distance * (1 - size * size * std::numeric_limits<double>::epsilon())) ++as_far;
    if (as_far > most) return std::nullopt;
  }
  return static_cast<double>(as_far) / (permutations + 1);
}

// Sums differences from the first value, so that the mean of equal values is that value to the bit.
double mean(std::span<const double> values) {
  const auto add = [first = values.front()](double sum, double value) { return sum + (value - first); };
  return values.front() + std::accumulate(values.begin(), values.end(), 0.0, add) / static_cast<double>(values.size());
}

// Indices of changes, each with its p-value.
using Changes = std::vector<std::pair<std::size_t, double>>;

Changes steps_of(std::span<const double> values) {
  Changes all;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] != values[i - 1]) all.emplace_back(i, 0);
  }
  return all;
}

Changes e_divisive(std::span<const double> values, std::uint64_t seed) {
  Random random(seed);
  Changes all;
  std::vector<std::size_t> bounds{0, values.size()};
  for (;;) {
    Split best;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const Split split = best_split(values.subspan(bounds[i], bounds[i + 1] - bounds[i]));
      if (split.distance > best.distance) best = {bounds[i] + split.at, split.distance};
    }
    if (best.at == 0) break;
    const auto p = p_value(values, bounds, best.distance, random);
    if (!p) break;
    all.emplace_back(best.at, *p);
    bounds.insert(std::upper_bound(bounds.begin(), bounds.end(), best.at), best.at);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<ChangePoint> with_means(const Changes& changes, std::span<const double> values) {
  std::vector<ChangePoint> all;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const std::size_t at = changes[i].first;
    const std::size_t from = i == 0 ? 0 : changes[i - 1].first;
    const std::size_t to = i + 1 == changes.size() ? values.size() : changes[i + 1].first;
    all.push_back({at, mean(values.subspan(from, at - from)), mean(values.subspan(at, to - at)), changes[i].second});
  }
  return all;
}

}  // namespace

std::vector<ChangePoint> exact_changes(std::span<const double> values) { return with_means(steps_of(values), values); }

std::vector<ChangePoint> noisy_changes(std::span<const double> values, std::uint64_t seed) {
  return with_means(e_divisive(values, seed), values);
}

}  // namespace plumb
