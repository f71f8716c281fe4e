#pragma once

#include <span>
#include <vector>

#include "reports/judge/truth.h"
#include "reports/report.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

struct Judgement {
  std::vector<TruthCheck> checks;
  std::vector<InvariantCheck> invariants;
  Verdict verdict = Verdict::plausible;
};

/// Holds a trace against what must come true. Each reading may be off by what the scenario allows for this way of
/// stepping, and by the round-off of its arithmetic, or by an absolute tolerance where one is stated. What is not
/// finite, or could not be read, never passes. What the engine does not report counts neither way: with nothing else
/// to judge by it is plausible. `truth` answers the expectations that leave the value to the closed form; without it
/// they cannot pass. The invariants that apply to the scene are held against the trace, too.
Judgement judge(const Scene&, std::span<const Expectation>, const Trace&, const Stepping&, const Truth* truth);

/// wrong where an invariant is broken or a reading is off, right where a reading passed, else plausible.
Verdict concluded(std::span<const TruthCheck>, std::span<const InvariantCheck>);

/// How far a quantity may be off at the end of a trace by rounding alone, in its unit.
double round_off(Quantity, std::size_t body, const Scene&, const Trace&, const Stepping&);

}  // namespace plumb
