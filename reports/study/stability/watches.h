#pragma once

#include "reports/study/stability/trial.h"

/// What counts as failing.
namespace plumb {

using SharedScene = std::shared_ptr<const Scene>;

/// Topples: a dynamic body has turned by more than an angle, rad, or come down by more than `drop`, m.
Watch topples(const SharedScene&, double angle, double drop);

/// Drifts: a dynamic body's centre has moved from its start by more than `way`, m, across gravity.
Watch drifts(const SharedScene&, double way);

/// Sinks: two bodies overlap by more than `depth`, m, beyond the gap that contacts may stand off by, m. Looked at ten
/// times a second.
Watch sinks(const SharedScene&, double depth, double gap);

/// Gains energy: the scene has more than at the start by more than a share of the energy that it can turn over.
Watch gains_energy(const SharedScene&, double share);

/// Jitters: over the last second a dynamic body's way was longer than still_way, m; drifts, where more than half of
/// that brought it away.
Watch is_restless(const SharedScene&, double still_way);

/// Sinks: what holds two bodies together has let their centres come farther apart than `length`, m.
Watch gives_way(const SharedScene&, std::size_t a, std::size_t b, double length);

/// A structure of bodies about `size` m large that should stand still, if contacts may stand off by `gap`, m.
std::vector<Watch> status(const SharedScene&, double size, double gap);

}  // namespace plumb
