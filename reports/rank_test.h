#pragma once

#include <span>
#include <vector>

namespace plumb {

/// Whether one of two samples tends to larger values (H. B. Mann, D. R. Whitney, 1947), two-sided.
struct RankTest {
  double p = 1;       // chance of ranks at least as uneven if both are drawn alike
  double effect = 0;  // share of pairs where a's is larger less that where b's is (N. Cliff, 1993): -1 ... 1
};

/// Exact for samples without ties and up to 20 each; otherwise by the normal approximation, with ties and continuity
/// corrected for. Infinite values count as larger than all others. Throws std::invalid_argument for an empty sample or
/// one with a NaN.
RankTest rank_test(std::span<const double> a, std::span<const double> b);

/// Which of several p-values stand at that level together: the chance of even one false alarm is at most `level`
/// (S. Holm, 1979).
std::vector<bool> significant(std::span<const double> p, double level);

}  // namespace plumb
