#include "reports/study/statistics/verdict.h"

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

namespace {

constexpr double least_expected = 5;  // draws in a bin, so that Pearson's statistic is as good as chi-square (Cochran)

void decide(EnsembleFinding& finding, double low, double high, double resolution) {
  const Estimate& found = finding.interval;
  const double outside = std::max({low - found.value, found.value - high, 0.0});
  finding.off = outside > 0 ? outside / found.error : 0;
  if (found.high < low || found.low > high) {
    finding.verdict = EnsembleVerdict::differs;
  } else if (found.half_width() <= resolution) {
    finding.verdict = EnsembleVerdict::agrees;
  } else {
    const double ratio = found.half_width() / resolution;
    finding.needed = static_cast<std::size_t>(std::ceil(static_cast<double>(finding.draws) * ratio * ratio));
  }
}

EnsembleFinding finding_of(const Statistic& statistic, std::span<const double> values, double miss) {
  EnsembleFinding finding{.statistic = statistic.name,
                          .idealisation = statistic.idealisation,
                          .draws = values.size(),
                          .interval = mean_interval(values, miss)};
  decide(finding, statistic.low, statistic.high, statistic.resolution);
  return finding;
}

struct Bin {
  double expected = 0, counted = 0;
};

// Bins from either end are joined to their neighbour until each is expected to have enough draws.
std::vector<Bin> joined(std::vector<Bin> bins) {
  const auto join_front = [&bins] {
    while (bins.size() > 1 && bins.front().expected < least_expected) {
      bins[1].expected += bins[0].expected;
      bins[1].counted += bins[0].counted;
      bins.erase(bins.begin());
    }
  };
  join_front();
  std::reverse(bins.begin(), bins.end());
  join_front();
  return bins;
}

// Pearson's X^2 of n draws in bins of the expected shares. (X^2 - f)/n, f degrees of freedom, estimates the sum of
// (share - expected)^2/expected without bias, and is 0 on average if the distribution is the expected one.
EnsembleFinding finding_of(const Distribution& expected, std::span<const double> values, double miss) {
  const auto n = static_cast<double>(values.size());
  std::vector<Bin> bins;
  for (const double share : expected.shares) bins.push_back({share * n, 0});
  for (const double value : values) {
    const double bin = std::round(value + expected.offset);
    bins[static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins.size() - 1)))].counted += 1;
  }
  bins = joined(std::move(bins));
  if (bins.size() < 2) throw std::invalid_argument("too few draws for chi-square");
  double x = 0;
  for (const Bin& bin : bins) x += (bin.counted - bin.expected) * (bin.counted - bin.expected) / bin.expected;
  const auto freedom = static_cast<double>(bins.size() - 1);
  const double most = chi_square_quantile(1 - miss, freedom);
  EnsembleFinding finding{.statistic = expected.name, .idealisation = expected.idealisation, .draws = values.size()};
  // One-sided: too good a fit is no reason to differ.
  finding.interval = {(x - freedom) / n, (x - most) / n, x / n, std::sqrt(2 * freedom) / n};
  decide(finding, 0, 0, expected.resolution);
  return finding;
}

}  // namespace

const char* name_of(EnsembleVerdict verdict) {
  switch (verdict) {
    case EnsembleVerdict::agrees:
      return "agrees";
    case EnsembleVerdict::differs:
      return "differs";
    case EnsembleVerdict::undecided:
      return "undecided";
  }
  return "";
}

std::vector<EnsembleFinding> judge_draws(const Ensemble& ensemble, std::span<const EnsembleDraw> draws, double miss) {
  const auto column = [&](std::size_t index) {
    std::vector<double> values;
    for (const EnsembleDraw& draw : draws) values.push_back(draw[index]);
    return values;
  };
  std::vector<EnsembleFinding> findings;
  for (std::size_t i = 0; i < ensemble.statistics.size(); ++i)
    findings.push_back(finding_of(ensemble.statistics[i], column(i), miss));
  if (ensemble.distribution)
    findings.push_back(finding_of(*ensemble.distribution, column(ensemble.distribution->statistic), miss));
  return findings;
}

double worst_difference(std::span<const EnsembleFinding> findings) {
  double worst = 0;
  for (const EnsembleFinding& one : findings) {
    if (!one.idealisation && one.verdict == EnsembleVerdict::differs) worst = std::max(worst, one.off);
  }
  return worst;
}

}  // namespace plumb
