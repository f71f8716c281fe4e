#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "reports/study/statistics/ensemble.h"

/// What an ensemble's draws say about its statistics, by confidence intervals from distributions that the standard
/// library has only as generators. The conclusion of the whole study from them.
namespace plumb {

struct Findings;
struct JobResult;

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

/// agrees: the interval touches the band and is narrow enough to tell. differs: it lies outside. undecided: it touches
/// the band, but is too wide.
enum class EnsembleVerdict { agrees, differs, undecided };

/// "agrees", "differs", "undecided".
const char* name_of(EnsembleVerdict);

struct EnsembleFinding {
  std::string statistic;
  bool idealisation = false;
  std::size_t draws = 0;
  Estimate interval;
  EnsembleVerdict verdict = EnsembleVerdict::undecided;
  double off = 0;          // standard errors from the value to the band; 0 within it
  std::size_t needed = 0;  // draws in all after which the interval would be narrow enough, if undecided
};

/// A finding for each statistic, and for the distribution if there is one. Each interval misses the truth with the
/// probability `miss`. Takes at least two draws.
std::vector<EnsembleFinding> judge_draws(const Ensemble&, std::span<const EnsembleDraw>, double miss);

/// The largest number of standard errors by which a statistic that is no idealisation differs; 0 if none does.
double worst_difference(std::span<const EnsembleFinding>);

/// The probability that any of all intervals of a study misses its truth: each misses with this, divided by their
/// number (Bonferroni).
constexpr double statistics_miss = 0.01;

/// The ensemble's steps, runs, statistics with their bands and sources, and control.
nlohmann::ordered_json description_of(const Ensemble&);

/// From the results of all runs: a verdict for each statistic and engine, for the console, the page and as a table.
Findings conclude_statistics(const std::vector<const Ensemble*>&, const std::vector<JobResult>&);

}  // namespace plumb
