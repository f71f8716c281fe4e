#pragma once

#include <cstddef>

#include "reports/trace.h"
#include "scenarios/scenario.h"

/// Errors that rounding alone can cause, from what an engine states of its arithmetic.
namespace plumb {

/// The relative error at the end of a trace of a number that is stored once a sub-step: it is rounded n times, by the
/// unit round-off u each, and its increments together by one or two u more: (n + 2) u of its largest magnitude.
double trace_rounding(const Trace&, const Stepping&);

/// The same within one step, for a number that a solver updates repeatedly. No method here iterates over the contacts
/// more than some tens of times; in longer solves the error stops growing.
double solver_rounding(const Stepping&);

/// m/s, what a velocity's rounding is a share of besides its own size: 0 for most methods, the position over the step
/// for one that keeps velocities as differences of positions. Likewise of angles.
double differenced(const Stepping&, double position, double step);

/// How far a quantity may be off at the end of a trace by rounding alone, in its unit. `body` matters only for
/// quantities of a body.
double quantity_rounding(Quantity, std::size_t body, const Scene&, const Trace&, const Stepping&);

}  // namespace plumb
