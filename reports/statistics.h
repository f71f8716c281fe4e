#pragma once

#include <span>
#include <vector>

/// Statistics of samples: quartiles and rank tests.
namespace plumb {

struct Quartiles {
  double low = 0, median = 0, high = 0;
};

/// Quartiles with linear interpolation between order statistics (Hyndman and Fan's type 7); zeros for an empty sample.
Quartiles quartiles(std::vector<double> values);

/// Whether one of two samples tends to larger values (H. B. Mann, D. R. Whitney, 1947), two-sided.
struct RankTest {
  double p = 1;       // probability of ranks at least as uneven if both samples come from one distribution
  double effect = 0;  // share of pairs with a > b less that with a < b (N. Cliff, 1993): -1 ... 1
};

/// Exact for samples without ties and of up to 20 values each; otherwise the normal approximation, corrected for ties
/// and continuity. Infinite values rank above all others. Throws std::invalid_argument for an empty sample or a NaN.
RankTest rank_test(std::span<const double> a, std::span<const double> b);

/// Which of several p-values are significant together: the probability of even one false positive is at most `level`
/// (S. Holm, 1979).
std::vector<bool> significant(std::span<const double> p, double level);

}  // namespace plumb
