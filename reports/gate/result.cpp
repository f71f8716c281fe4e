#include "reports/gate/result.h"

#include <algorithm>
#include <tuple>

namespace plumb {

const char* name_of(Rule rule) {
  switch (rule) {
    case Rule::presence:
      return "presence";
    case Rule::verdict:
      return "verdict";
    case Rule::bound:
      return "bound";
    case Rule::bits:
      return "bits";
    case Rule::time:
      return "time";
  }
  return "";
}

const char* name_of(Change change) {
  switch (change) {
    case Change::worse:
      return "worse";
    case Change::changed:
      return "changed";
    case Change::better:
      return "better";
    case Change::missing:
      return "missing";
    case Change::added:
      return "new";
  }
  return "";
}

std::optional<Rule> caught_by(const GateResult& result, const RunKey& run) {
  std::optional<Rule> coarsest;
  for (const Regression& one : result.regressions) {
    if (one.run == run && (!coarsest || one.rule < *coarsest)) coarsest = one.rule;
  }
  return coarsest;
}

// First verdicts that got worse, then what is missing, then numbers by the ratio of difference and tolerance.
void sort(std::vector<Regression>& regressions) {
  const auto rank = [](const Regression& one) {
    const bool verdict_worse = one.rule == Rule::verdict && one.change == Change::worse;
    const int group = verdict_worse                   ? 0
                      : one.change == Change::missing ? 1
                      : one.rule == Rule::bound       ? 2
                      : one.rule == Rule::time        ? 3
                      : one.rule == Rule::verdict     ? 4
                      : one.rule == Rule::bits        ? 5
                                                      : 6;
    return std::tuple<int, double, const RunKey&, const std::string&>(group, -one.times, one.run, one.metric);
  };
  std::sort(regressions.begin(), regressions.end(),
            [&](const Regression& a, const Regression& b) { return rank(a) < rank(b); });
}

}  // namespace plumb
