#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reference/faults/altered_engine.h"
#include "reports/run/run.h"

/// Scenes of which only statistics are known. Each ensemble joins Catalog<Ensemble> from its own file in
/// reports/study/statistics/ensembles/.
namespace plumb {

/// What is known of the mean of a number over all draws.
struct Statistic {
  std::string name;
  std::string unit;           // "" if dimensionless
  double low = 0, high = 0;   // where mechanics puts its mean: the same twice, or a band
  double resolution = 0;      // half-width up to which an interval that touches the band agrees with it
  std::string source;         // of the band
  bool idealisation = false;  // a textbook's simplification: to differ from it is no fault of an engine
};

/// What is known of how one of the numbers, a whole one, is distributed: Pearson's chi-square tests it.
struct Distribution {
  std::string name;
  std::size_t statistic = 0;  // index of the number; the distribution is that of its value + offset
  double offset = 0;
  std::vector<double> shares;  // probability of 0, 1, 2 ...
  double resolution = 0;       // sum of (share - expected)^2/expected that must be seen
  std::string source;
  bool idealisation = true;
};

/// The numbers of one draw, in the order of the ensemble's statistics.
using EnsembleDraw = std::vector<double>;

/// One run of an ensemble: gives scenes to an engine. What it cannot run, or fails in, ends the run by an exception.
class EnsembleRun {
 public:
  EnsembleRun(const EngineConfig& config, double dt) : config_(config), dt_(dt) {}

  /// Calls the observer at every moment until it returns false or the scene ends.
  void watch(const Scene&, const Observer&);
  /// The trace with the contacts of each step. An engine that reports none cannot run it.
  std::shared_ptr<const Trace> record(const Scene&);

  double dt() const { return dt_; }
  double stepping() const { return stepping_; }  // s of computing time in steps so far

 private:
  void take(const Outcome&);

  const EngineConfig& config_;
  double dt_;
  double stepping_ = 0;
};

/// Random scenes of one kind, and what their statistics must be.
struct Ensemble {
  std::string name;
  std::string question;
  double dt = 0;                      // s
  int runs = 0;                       // each with a seed of its own: 1, 2, 3 ...
  int large = 0;                      // with --large
  std::vector<Statistic> statistics;  // at least one
  /// Independent draws, all from the seed. The same bits for the same engine and seed.
  std::function<std::vector<EnsembleDraw>(EnsembleRun&, std::uint64_t seed)> draws;
  /// An engine that must differ: in at least one statistic that is no idealisation.
  std::function<Control()> control;
  std::optional<Distribution> distribution = std::nullopt;
};

/// All draws of a run, or why there are none.
struct RunResult {
  Status status = Status::ok;
  std::string reason;
  std::vector<EnsembleDraw> draws;
  double stepping = 0;  // s of computing time
};

/// Throws std::logic_error if a draw has another number of values than the ensemble has statistics.
RunResult run_ensemble(const Ensemble&, const EngineConfig&, std::uint64_t seed);

}  // namespace plumb
