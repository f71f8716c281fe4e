#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/gate/baseline.h"

namespace plumb {

/// What caught an regression, the crudest first. presence: a run has come or gone. verdict: what physics says of it
/// became another. bound: a number moved farther than the rounding of another platform explains. bits: on the same
/// platform not every bit is the same. time: steps take longer than in another build that they were timed beside.
enum class Rule { presence, verdict, bound, bits, time };
enum class Change { worse, changed, better, missing, added };

/// "presence", "verdict", "bound", "bits", "time".
const char* name_of(Rule);

/// "worse", "changed", "better", "missing", "new".
const char* name_of(Change);

/// One thing that is not as accepted.
struct Regression {
  RunKey run;
  std::string metric;                  // "verdict", "bits", "run", or the name of a number
  std::string before, now, tolerance;  // with unit; "" where there is nothing to say
  std::string why;                     // a sentence
  Rule rule = Rule::bits;
  Change change = Change::changed;
  double times = 0;  // the difference against what is allowed; 0 where that says nothing
};

/// What a gate says: it passes when all is as accepted. Better is not as accepted, either, until it is.
struct GateResult {
  std::string verdict;  // one line
  std::vector<RunKey> runs;
  std::vector<Regression> regressions;  // worst first
  std::vector<std::string> notes;       // on what the comparison rests

  bool passed() const { return regressions.empty(); }
};

/// The crudest rule that caught a run; nothing where none did.
std::optional<Rule> caught_by(const GateResult&, const RunKey&);

/// Worst first, and always in the same order.
void sort(std::vector<Regression>&);

}  // namespace plumb
