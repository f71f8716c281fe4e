#pragma once

#include <span>
#include <vector>

#include "reports/judge/observe.h"
#include "reports/report.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

/// Judges traces against the truth and the invariants. Pure: runs nothing.
namespace plumb {

struct Judgement {
  std::vector<TruthCheck> checks;
  std::vector<InvariantCheck> invariants;
  Verdict verdict = Verdict::plausible;
};

/// Judges a trace by a scenario's expectations and the invariants of its scene. The tolerance of a check is what the
/// scenario allows for this stepping plus the rounding of the engine's arithmetic, or an absolute one if the
/// expectation states it; its scale is that of the scene (see scale.h). A value that is not finite or could not be read
/// never passes. A quantity that the engine does not report counts neither way. `truth`, which may be null, gives the
/// values that expectations leave to the closed form; without it they cannot pass.
Judgement judge(const Scene&, std::span<const Expectation>, const Trace&, const Stepping&, const Truth* truth);

/// Only the checks of these expectations.
std::vector<TruthCheck> check_expectations(const Scene&, std::span<const Expectation>, const Trace&, const Stepping&,
                                           const Truth* truth);

/// Judges a run together with runs of the same case with shifted steps (see run/case_run.h): every check is that of its
/// worst phase and gives the spread of the errors, and the verdict is the worst. A null phase did not reach its end and
/// is wrong.
Judgement judge_phases(const Scene&, std::span<const Expectation>, const Trace&, std::span<const Trace* const> shifted,
                       const Stepping&, const Truth* truth);

/// wrong if an invariant is broken, whatever the truth says, or a truth check fails. Otherwise, where bodies move and
/// every truth check would pass if they did not (energy, for example), nothing was asked about the motion, and it is
/// judged as if there were no truth. With truth: coarse if one check is farther off than `right_share` of its scale;
/// right if every quantity whose value they ask for has evidence at that time or later, which one that is not reported
/// never has; else no evidence. Without: plausible if an invariant was tested, else no evidence.
Verdict verdict_of(std::span<const TruthCheck> truth, std::span<const InvariantCheck>);

}  // namespace plumb
