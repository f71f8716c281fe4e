#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "reports/run/run.h"
#include "reports/statistics.h"

/// Beyond its horizon a scene is compared as a whole: many runs of each engine from starts that differ at random.
namespace plumb {

/// One quantity of every run that came to its end.
struct Sample {
  std::string quantity;
  std::string unit;
  std::vector<double> values;
};

/// `members` runs with starts perturbed by up to `size`, m; the seeds are `first_seed` and those that follow. Energy
/// and spread are those of the end; a run that has not come to rest by then rests at infinity.
std::vector<Sample> ensemble_of(const Scene&, const EngineConfig&, double dt, double size, int members,
                                std::uint64_t first_seed);

/// What two ensembles say of one quantity.
struct Contrast {
  std::string quantity;
  std::string unit;
  Quartiles a, b;
  double p = 1;
  double effect = 0;       // -1 ... 1, see RankTest
  bool different = false;  // at the level of all contrasts of the call together
};

/// The chance that `contrast` calls two ensembles of the same engine different in anything.
constexpr double false_alarm = 0.01;

std::vector<Contrast> contrast(std::span<const Sample> a, std::span<const Sample> b);

}  // namespace plumb
