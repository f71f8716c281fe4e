#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reports/compare/ensembles.h"
#include "reports/report.h"
#include "reports/run/run.h"

/// How far ahead a scene can be predicted, until runs that started next to each other have diverged, and the comparison
/// of engines beyond that.
namespace plumb {

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

/// Compares the engines of one case beyond its horizon; `records` and `comparisons` are those of the case. Every run
/// that has a horizon of its own gets it as the metric "horizon". If the scene has one, every two engines are compared
/// by ensembles of `members` runs from the same perturbed starts (see `add_ensembles`), and each with that of a refined
/// engine, ours in double precision at half the step: the reason of a record tells if they differ. That has as many of
/// `members` runs as `budget` body-steps allow; it is left out if those are too few to tell.
void compare_beyond_horizon(const Case&, std::span<const EngineConfig>, double dt, int members, std::size_t budget,
                            std::span<RunRecord> records, std::span<Comparison> comparisons);

/// The description of the metric "horizon".
MetricNote horizon_note();

}  // namespace plumb
