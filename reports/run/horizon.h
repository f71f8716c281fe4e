#pragma once

#include <optional>

#include "reports/run/run.h"
#include "reports/trace.h"

/// How far ahead a scene can be told: until runs that began next to each other have parted.
namespace plumb {

/// m, by which starts differ: a billionth, or what the engine's arithmetic can still tell from nothing.
double smallest_difference(const Scene&, const Stepping&);

/// m, by which two answers differ that have parted: a thousandth of the smallest body.
double parted_by(const Scene&);

/// s, the first moment at which one of a few runs that began up to `smallest_difference` away has parted from this
/// one; nothing where none does. `trace` is the config's own run of the scene with steps of dt.
std::optional<double> horizon_of(const Scene&, const EngineConfig&, double dt, const Trace&);

}  // namespace plumb
