#pragma once

#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

/// The share of its largest magnitude that a number stored once a sub-step may be off by at the end of a trace: it is
/// rounded n times, by the unit round-off u each, and its increments together by one or two u more: (n + 2) u.
double roundings(const Trace&, const Stepping&);

/// The same within a single step, for a number that a solver goes over again and again. Contacts are swept some tens
/// of times at most by any method here; where more is done the error no longer grows.
double roundings_of_solver(const Stepping&);

}  // namespace plumb
