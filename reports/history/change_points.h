#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Finding where a series of numbers changes for good.
namespace plumb {

struct ChangePoint {
  std::size_t at = 0;            // index of the first value after the change
  double before = 0, after = 0;  // means, up to the neighbouring change points
  double p = 0;                  // probability that random order alone looks as changed; 0 for exact changes
};

/// The probability that a change is found in a series of noise.
constexpr double change_level = 0.01;

/// Of a series without noise: every value that differs from the one before is a change.
std::vector<ChangePoint> exact_changes(std::span<const double> values);

/// The fewest values on each side of a change of a noisy series; fewer do not show how much they scatter.
constexpr std::size_t least_values = 3;

/// Of a noisy series, in order. All values must be finite.
///
/// The method is E-divisive (Matteson and James, A nonparametric approach for multiple change point analysis of
/// multivariate data, JASA 109, 2014): find the split with the largest energy distance between both sides, weighted by
/// their sizes; accept it if at most `change_level` of 499 random permutations of the values have one as large; then
/// search each side, until no split is accepted. It assumes nothing about the distribution except that without a change
/// every order of the values is equally likely. The permutations depend only on the seed.
std::vector<ChangePoint> noisy_changes(std::span<const double> values, std::uint64_t seed = 0);

}  // namespace plumb
