#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Where a series of numbers changes for good.
namespace plumb {

struct ChangePoint {
  std::size_t at = 0;            // the first value after it
  double before = 0, after = 0;  // means, up to the neighbouring change points
  double p = 0;                  // how often a series that does not change would look as changed; 0 of exact changes
};

/// The chance that a series of noise alone is said to change.
constexpr double change_level = 0.01;

/// In order of their places. All values must be finite.
///
/// What repeats to the bit has no noise: where at least half of the values are the one before, each that is not is a
/// change. Else E-divisive (Matteson and James, A nonparametric approach for multiple change point analysis of
/// multivariate data, JASA 109, 2014): the split is looked for at which the energy distance between both sides, by
/// their sizes, is largest, and stands where no more than `change_level` of 499 random orders of the same values have
/// one as large; then each side is looked at, as long as a split stands. Nothing is supposed of the distribution, but
/// that values without a change could as well have come in another order. The orders are the same for the same seed.
std::vector<ChangePoint> change_points(std::span<const double> values, std::uint64_t seed = 0);

}  // namespace plumb
