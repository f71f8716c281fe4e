#pragma once

#include <span>

/// Confidence intervals, from distributions that the standard library has only as generators.
namespace plumb {

/// P(T <= t) of Student's t with that many degrees of freedom, > 0.
double student_share(double t, double freedom);

/// The t with P(T <= t) = share, 0 < share < 1.
double student_quantile(double share, double freedom);

/// P(X <= x) of chi-square with that many degrees of freedom, > 0.
double chi_square_share(double x, double freedom);

/// The x with P(X <= x) = share, 0 < share < 1.
double chi_square_quantile(double share, double freedom);

/// An estimate with its interval.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;
  double error = 0;  // standard error of the value

  double half_width() const { return (high - low) / 2; }
};

/// The mean of independent values with Student's interval: it misses the mean of the distribution with the probability
/// `miss`, if the mean of so many values is as good as normal. Throws std::invalid_argument for fewer than two values.
Estimate mean_interval(std::span<const double> values, double miss);

}  // namespace plumb
