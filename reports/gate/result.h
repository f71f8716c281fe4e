#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/gate/baseline.h"

namespace plumb {

/// The rule that found a regression, the coarsest first. presence: a run is missing or new. verdict: the verdict of a
/// run or the status of a check changed. bound: a number changed by more than the rounding of another platform
/// explains. bits: not every bit is the same on the same platform. time: steps take longer than in another build that
/// was timed beside this one.
enum class Rule { presence, verdict, bound, bits, time };
enum class Change { worse, changed, better, missing, added };

/// "presence", "verdict", "bound", "bits", "time".
const char* name_of(Rule);

/// "worse", "changed", "better", "missing", "new".
const char* name_of(Change);

/// One difference from what was accepted, even one for the better.
struct Regression {
  RunKey run;
  std::string metric;                  // "verdict", "bits", "run", or the name of a number
  std::string before, now, tolerance;  // with unit; "" if it does not apply
  std::string why;                     // a sentence
  Rule rule = Rule::bits;
  Change change = Change::changed;
  double times = 0;  // how many times the tolerance the difference is; 0 if that means nothing
};

/// What `plumb check` found. It passes if everything is as accepted; an improvement must be accepted first, too.
struct GateResult {
  std::string verdict;  // one line
  std::vector<RunKey> runs;
  std::vector<Regression> regressions;  // worst first
  std::vector<std::string> notes;       // what was compared with what

  bool passed() const { return regressions.empty(); }
};

/// The coarsest rule that found a regression of this run; nullopt if none did.
std::optional<Rule> caught_by(const GateResult&, const RunKey&);

/// Sorts worst first, in an order that does not depend on the input's.
void sort(std::vector<Regression>&);

/// Compares results with what was accepted. On the same platform every bit must be the same; on another one, numbers
/// may differ by their bounds. Verdicts must be the same on both. Throws std::invalid_argument if the time steps
/// differ.
GateResult compare(const Baseline& before, const Baseline& now);
GateResult compare(const Baseline& before, const Report& now);

}  // namespace plumb
