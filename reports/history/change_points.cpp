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

constexpr int orders = 499;              // the smallest p is 1/500
constexpr std::size_t least_values = 3;  // values on each side; of fewer, nothing can be said of how they scatter

struct Split {
  std::size_t at = 0;
  double distance = -std::numeric_limits<double>::infinity();
};

// Of values x, split in the first m and the n that follow them up to some end (which may lie before the last: further
// changes would blur this one), with sums over pairs W within and B between:
//
//   Q = m n/(m + n) (2 B/(m n) - W_m/(m (m-1)/2) - W_n/(n (n-1)/2))
//
// All sums come from those within each stretch, and B is what the stretch of both has more than its parts.
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

// Fisher and Yates.
void shuffle(std::span<double> values, Random& random) {
  for (std::size_t left = values.size(); left > 1; --left) {
    std::swap(values[left - 1], values[static_cast<std::size_t>(random.next() % left)]);
  }
}

// p of the best split of all segments: how often one as far apart comes of the segments' values in other orders;
// nothing as soon as it is above the level.
std::optional<double> chance(std::span<const double> values, const std::vector<std::size_t>& bounds, double distance,
                             Random& random) {
  const int most = static_cast<int>(change_level * (orders + 1));
  std::vector<double> mixed(values.begin(), values.end());
  int as_far = 1;  // the order as it is
  for (int order = 0; order < orders; ++order) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const auto segment = std::span(mixed).subspan(bounds[i], bounds[i + 1] - bounds[i]);
      shuffle(segment, random);
      farthest = std::max(farthest, best_split(segment).distance);
    }
    // The same sides in another order are as far apart but for the rounding of their sums of n^2/2 terms.
    const double size = static_cast<double>(values.size());
    if (farthest >= distance * (1 - size * size * std::numeric_limits<double>::epsilon())) ++as_far;
    if (as_far > most) return std::nullopt;
  }
  return static_cast<double>(as_far) / (orders + 1);
}

// From the first on, so that the mean of equal values is that value to the bit.
double mean(std::span<const double> values) {
  const auto add = [first = values.front()](double sum, double value) { return sum + (value - first); };
  return values.front() + std::accumulate(values.begin(), values.end(), 0.0, add) / static_cast<double>(values.size());
}

// Places and p of what changes.
using Places = std::vector<std::pair<std::size_t, double>>;

Places steps_of(std::span<const double> values) {
  Places all;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] != values[i - 1]) all.emplace_back(i, 0);
  }
  return all;
}

Places e_divisive(std::span<const double> values, std::uint64_t seed) {
  Random random(seed);
  Places all;
  std::vector<std::size_t> bounds{0, values.size()};
  for (;;) {
    Split best;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const Split split = best_split(values.subspan(bounds[i], bounds[i + 1] - bounds[i]));
      if (split.distance > best.distance) best = {bounds[i] + split.at, split.distance};
    }
    if (best.at == 0) break;
    const auto p = chance(values, bounds, best.distance, random);
    if (!p) break;
    all.emplace_back(best.at, *p);
    bounds.insert(std::upper_bound(bounds.begin(), bounds.end(), best.at), best.at);
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

std::vector<ChangePoint> change_points(std::span<const double> values, std::uint64_t seed) {
  const Places steps = steps_of(values);
  const bool still = values.size() > 1 && 2 * steps.size() <= values.size() - 1;
  const Places places = still ? steps : e_divisive(values, seed);
  std::vector<ChangePoint> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t at = places[i].first;
    const std::size_t from = i == 0 ? 0 : places[i - 1].first;
    const std::size_t to = i + 1 == places.size() ? values.size() : places[i + 1].first;
    all.push_back({at, mean(values.subspan(from, at - from)), mean(values.subspan(at, to - at)), places[i].second});
  }
  return all;
}

}  // namespace plumb
