#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reports/report.h"
#include "reports/run/run.h"

namespace plumb {

/// s, the scene's horizon: that of our engine in double, which sees the smallest differences; nothing where it can be
/// told to its end.
std::optional<double> horizon_of(const Scene&, double dt);

/// Looks beyond the horizon of one case, whose runs and comparisons these are. Every run that has one gets its engine's
/// own as the metric "horizon". Where the scene itself has one, engines are compared as ensembles of `members` runs,
/// all from the same perturbed starts: the comparison's verdict is `beyond_horizon` where they do not differ, and
/// `plausible`, with the reason what differs by how much, where they do. Verdicts worse than that stay.
void look_beyond(const Case&, std::span<const EngineConfig> able, double dt, int members, std::span<RunRecord>,
                 std::span<Comparison>);

/// What "horizon" means.
MetricNote horizon_note();

}  // namespace plumb
