#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reports/compare/ensembles.h"
#include "reports/judge/method_error.h"
#include "reports/report.h"
#include "reports/run/run.h"

/// How far small displacements of the start take a scene, which is what its motion makes of a method's own error; how
/// far ahead it can be predicted, until runs that started next to each other have diverged; and the comparison of
/// engines beyond that.
namespace plumb {

/// Differences to the unperturbed run.
struct PoseShift {
  double place = 0;   // m
  double angle = 0;   // rad
  double energy = 0;  // J, of the scene
};

/// Our engine in double precision, with default settings.
EngineConfig our_config();

/// Every dynamic body moved at random by up to `size`, m, and turned so that its rim moves as much.
Scene displaced(const Scene&, double size, std::uint64_t seed);

/// Measured with our engine in double precision at half the step, by displacements of several sizes, since growth
/// depends on the size where an impact may be missed.
class Growth {
 public:
  /// Up to a time, s. Without growth if our engine cannot run the scene to there.
  Growth(const Scene&, double dt, double until);

  std::size_t moments() const { return stress_.size(); }
  /// s, of the moments, every dt.
  double time(std::size_t moment) const { return static_cast<double>(moment) * dt_; }

  /// By how much an engine that steps like this may be off at a moment: its own error by then, wherever it was made,
  /// times the largest growth by then of any displacement up to that size. Nullopt where that error is larger than any
  /// displacement that was tried, a tenth of the smallest body.
  std::optional<PoseShift> allowance(const Stepping&, std::size_t moment, std::size_t body) const;
  /// The largest growth by a moment of any displacement up to the smallest size tried that is at least `size`, m: per
  /// m, and that size. Nullopt if none is.
  struct Factor {
    PoseShift per_metre;
    double tried = 0;  // m
  };
  std::optional<Factor> factor(double size, std::size_t moment, std::size_t body) const;

  /// The first of these factors.
  MethodError own_error(const Stepping&, std::size_t moment) const;

 private:
  struct Displaced {
    double size = 0;                // m
    std::vector<PoseShift> growth;  // per m of displacement so far, moment by moment, body by body
  };

  void displace(const Scene&, const EngineConfig&, const Trace& undisturbed, double size);

  double dt_;
  std::size_t bodies_;
  bool bounces_ = false;
  std::vector<Stress> stress_;        // moment by moment
  std::vector<double> force_;         // N, the largest outside of impacts and all weights, moment by moment
  std::vector<double> momentum_;      // kg m/s, the largest so far, the sum of all bodies' sizes
  std::vector<double> radius_;        // m, of each body
  std::vector<Displaced> displaced_;  // smallest first
};

/// m, the size of a perturbation of the start: 1e-9, or what the engine's arithmetic can just resolve.
double smallest_difference(const Scene&, const Stepping&);

/// m, the difference at which two runs have diverged: a tenth of the smallest body.
double divergence_distance(const Scene&);

/// s, the first moment at which one of a few runs perturbed by up to `smallest_difference` has diverged from this one;
/// nullopt if none does. `trace` is the config's own run of the scene with steps of dt.
std::optional<double> horizon_of(const Scene&, const EngineConfig&, double dt, const Trace& trace);

/// s, the horizon of the scene: that of our engine in double precision, which resolves the smallest differences.
/// Returns nullopt if the scene can be predicted to its end.
std::optional<double> horizon_of(const Scene&, double dt);

/// Runs `members` times with starts perturbed by up to `size`, m, and seeds from `first_seed` on. Runs that fail do not
/// count.
std::vector<EnsembleSample> run_ensemble(const Scene&, const EngineConfig&, double dt, double size, int members,
                                         std::uint64_t first_seed);

/// Runs of an ensemble: `most`, or as many, but at least six, as that many times the usual budget of body-steps allows.
int ensemble_members(const Scene&, double dt, int most);

/// Compares the engines of one case beyond its horizon; `records` and `comparisons` are those of the case. Every run
/// that has a horizon of its own gets it as the metric "horizon". If the scene has one, every two engines that are not
/// wrong anyway are compared by ensembles of ensemble_members() runs from the same perturbed starts (see
/// `add_ensembles`), and each with that of a refined engine, ours in double precision at half the step: the reason of a
/// record tells if they differ. That has as many of these runs as `budget` body-steps allow; it is left out if those
/// are too few to tell.
void compare_beyond_horizon(const Case&, std::span<const EngineConfig>, double dt, int most, std::size_t budget,
                            std::span<RunRecord> records, std::span<Comparison> comparisons);

/// The description of the metric "horizon".
MetricNote horizon_note();

}  // namespace plumb
