#include "reports/study/statistics/verdict.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {
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
