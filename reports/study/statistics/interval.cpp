#include "reports/study/statistics/interval.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace plumb {
namespace {

constexpr double tiny = 1e-300;
constexpr double settled = 1e-15;  // relative change at which a series or fraction has converged
constexpr int most_terms = 10000;

double off_zero(double value) { return std::abs(value) < tiny ? tiny : value; }

// The continued fraction of the incomplete beta function, by Lentz's method (NIST DLMF 8.17.22).
double beta_fraction(double a, double b, double x) {
  double c = 1;
  double d = 1 / off_zero(1 - (a + b) * x / (a + 1));
  double product = d;
  for (int m = 1; m < most_terms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / off_zero(1 + even * d);
    c = off_zero(1 + even / c);
    product *= c * d;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / off_zero(1 + odd * d);
    c = off_zero(1 + odd / c);
    product *= c * d;
    if (std::abs(c * d - 1) < settled) break;
  }
  return product;
}

// The regularized incomplete beta function I_x(a, b) (NIST DLMF 8.17).
double beta_share(double a, double b, double x) {
  if (x <= 0 || x >= 1) return x <= 0 ? 0 : 1;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
  if (x > (a + 1) / (a + b + 2)) return 1 - front * beta_fraction(b, a, 1 - x) / b;
  return front * beta_fraction(a, b, x) / a;
}

// The argument at which an increasing function has that value.
double solved(const std::function<double(double)>& share_at, double share, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (share_at(middle) < share ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

double student_share(double t, double freedom) {
  const double beyond = beta_share(freedom / 2, 0.5, freedom / (freedom + t * t)) / 2;
  return t < 0 ? beyond : 1 - beyond;
}

double student_quantile(double share, double freedom) {
  return solved([&](double t) { return student_share(t, freedom); }, share, -1e9, 1e9);
}

// The series of the incomplete gamma function: all its terms are positive, and the share is far below 1 where it is
// wanted (NIST DLMF 8.11.4).
double chi_square_share(double x, double freedom) {
  if (x <= 0) return 0;
  const double a = freedom / 2;
  double term = 1 / a;
  double sum = term;
  for (int n = 1; n < most_terms && term > settled * sum; ++n) {
    term *= x / 2 / (a + n);
    sum += term;
  }
  return std::min(1.0, sum * std::exp(a * std::log(x / 2) - x / 2 - std::lgamma(a)));
}

double chi_square_quantile(double share, double freedom) {
  return solved([&](double x) { return chi_square_share(x, freedom); }, share, 0, 100 * freedom + 1000);
}

Estimate mean_interval(std::span<const double> values, double miss) {
  if (values.size() < 2) throw std::invalid_argument("an interval takes at least two values");
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double error = std::sqrt(squares / (n - 1) / n);
  const double half = student_quantile(1 - miss / 2, n - 1) * error;
  return {mean, mean - half, mean + half, error};
}

}  // namespace plumb
