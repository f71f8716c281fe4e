#include "reports/timing/regressions.h"

#include <fmt/format.h>

#include "reports/statistics.h"

namespace plumb {
namespace {

std::string microseconds(const std::vector<double>& seconds) {
  return fmt::format("{:.4g} us a step", 1e6 * quartiles(seconds).median);
}

Regression regression_of(const RunKey& run, const JudgedTime& one, double least) {
  return {.run = run,
          .metric = "time",
          .before = microseconds(one.pair.before.cpu),
          .now = microseconds(one.pair.now.cpu),
          .tolerance = fmt::format("{:.1f} % more", 100 * least),
          .why = fmt::format("{:+.1f} %, by chance with p = {:.1g}", 100 * (one.time.ratio - 1), one.time.p),
          .rule = Rule::time,
          .change = Change::worse,
          .times = (one.time.ratio - 1) / least};
}

}  // namespace

void add_times(GateResult& result, const TimingReport& report, const std::string& engine) {
  std::size_t slower = 0;
  for (const JudgedTime& one : report.cases) {
    const RunKey run{.scenario = "time", .variant = one.pair.name, .engine = engine};
    result.runs.push_back(run);
    if (one.pace == Pace::no_result) result.notes.push_back("No time of " + one.pair.name + ": " + one.pair.no_result);
    if (one.pace != Pace::slower) continue;
    ++slower;
    result.regressions.push_back(regression_of(run, one, report.rule.least));
  }
  result.verdict += slower == 0 ? "; no step takes longer"
                                : fmt::format("; steps take LONGER in {} of {} cases", slower, report.cases.size());
  sort(result.regressions);
}

}  // namespace plumb
