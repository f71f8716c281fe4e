#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/statistics.h"
#include "reports/trace.h"

/// Compares two engines statistically, by ensembles of runs from perturbed starts. Beyond the horizon of a chaotic
/// scene single runs cannot be compared.
namespace plumb {

/// One quantity over the runs of an ensemble that reached their end.
struct EnsembleSample {
  std::string quantity;
  std::string unit;
  std::vector<double> values;
};

/// The quantities that ensembles are compared by, without values: energy and spread of the bodies at the end, and the
/// time at which they came to rest.
std::vector<EnsembleSample> empty_samples();

/// Adds one run to the samples of its ensemble. A run that does not come to rest counts with its end time.
void add_run(std::vector<EnsembleSample>&, const Scene&, const Trace&);

/// The difference of two ensembles in one quantity.
struct EnsembleDifference {
  std::string quantity;
  std::string unit;
  Quartiles a, b;
  double p = 1;
  double effect = 0;       // -1 ... 1, see RankTest
  bool different = false;  // significant at `false_positive_rate` over all quantities together
};

/// The probability that `compare_ensembles` calls two ensembles of the same engine different in any quantity.
constexpr double false_positive_rate = 0.01;

std::vector<EnsembleDifference> compare_ensembles(std::span<const EnsembleSample> a, std::span<const EnsembleSample> b);

/// "different: energy 1 against 2 J (...)", of ensembles of `members` runs; "" if they do not differ.
std::string differences_in_words(std::span<const EnsembleDifference>, int members);

/// Completes the comparison of two engines beyond the scene's horizon, s, by the differences of their ensembles of
/// `members` runs each: adds their metrics and, unless one of the runs is worse than plausible, sets the verdict to
/// `beyond_horizon` if the ensembles do not differ, and otherwise to `plausible`, with the differences as the reason.
void add_ensembles(Comparison&, std::span<const EnsembleDifference>, double horizon, int members);

}  // namespace plumb
