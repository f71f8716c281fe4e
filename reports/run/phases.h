#pragma once

#include <vector>

#include "reports/judge/truth.h"
#include "reports/judge/verdict.h"
#include "reports/run/run.h"

/// An impact falls somewhere between two steps, and how far it is off depends on where. One start is one draw; these
/// are several. The steps are shifted, not the scene: what must come true, and when, stays as it is.
namespace plumb {

/// The case as it is, and n - 1 times with a first step shorter than dt: by the fractions of k times the golden ratio,
/// which fill 0 ... 1 evenly for any n. The last step is cut so that all end with the scene.
std::vector<Case> phases(const Case&, int n);

/// As many as `judge_case` looks at.
constexpr int judged_phases = 8;

/// Holds the trace of a case as it is against what must come true (see `judge`). Where the scenario asks for it, runs
/// the other phases as well: every check becomes that of its worst phase and says its spread, the verdict becomes that
/// of the worst. A phase that does not come to its end is wrong.
Judgement judge_case(const Case&, const EngineConfig&, double dt, const Trace&, const Truth*);

}  // namespace plumb
