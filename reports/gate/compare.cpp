#include "reports/gate/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/judge/metric.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

// The higher the rank, the worse. A run beyond its horizon is as plausible as any other run of the scene would be; to
// refuse a scene is better than to get it wrong.
int rank(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return 0;
    case Verdict::coarse:
      return 1;
    case Verdict::plausible:
    case Verdict::beyond_horizon:
      return 2;
    case Verdict::no_evidence:
      return 3;
    case Verdict::not_supported:
      return 4;
    case Verdict::wrong:
      return 5;
    case Verdict::failed:
      return 6;
  }
  return 6;
}

int rank(CheckStatus status) {
  switch (status) {
    case CheckStatus::held:
      return 0;
    case CheckStatus::not_reported:
    case CheckStatus::not_applicable:
      return 1;
    case CheckStatus::broken:
      return 2;
  }
  return 2;
}

template <class Class>
Change change_between(Class before, Class now) {
  if (rank(now) == rank(before)) return Change::changed;
  return rank(now) > rank(before) ? Change::worse : Change::better;
}

// A file does not distinguish infinity from NaN.
bool same_number(double a, double b) { return a == b || (!std::isfinite(a) && !std::isfinite(b)); }

// The number may be missing on another platform, or only perturbed runs have it.
bool may_be_missing(const BaselineNumber& number) { return number.bound == unbounded; }

bool same(const BaselineNumber& a, const BaselineNumber& b) {
  return same_number(a.value, b.value) && same_number(a.tolerance, b.tolerance) && a.status == b.status;
}

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.10g}{}", value, unit.empty() || unit == "1" ? "" : " " + unit);
}

// The difference divided by its bound; 0 if the numbers are the same, neither is finite, or there is no bound.
double times_bound(const BaselineNumber& before, const BaselineNumber& now) {
  if (*before.bound == unbounded || same_number(before.value, now.value)) return 0;
  return error_ratio(std::abs(now.value - before.value), *before.bound);
}

// Numbers of checks are errors, so lower is better; a metric states which direction is better.
Change direction(const std::string& name, const BaselineNumber& before, const BaselineNumber& now) {
  const Metric* metric = Catalog<Metric>::find(name);
  const Better better = before.status ? Better::lower : metric == nullptr ? Better::neither : metric->better;
  if (better == Better::neither) return Change::changed;
  if (std::isfinite(before.value) != std::isfinite(now.value))
    return std::isfinite(now.value) ? Change::better : Change::worse;
  const bool higher = now.value > before.value;
  return higher == (better == Better::lower) ? Change::worse : Change::better;
}

// Compares one run with its baseline.
class RunComparison {
 public:
  RunComparison(const RunKey& key, const BaselineRun& before, const BaselineRun& now, bool same_platform)
      : key_(key), before_(before), now_(now), same_platform_(same_platform) {}

  std::vector<Regression> regressions() {
    compare_verdicts();
    // A run that did not reach its end has no numbers.
    if (now_.numbers.empty() || before_.numbers.empty()) {
      if (same_platform_) compare_bits();
      return std::move(regressions_);
    }
    for (const auto& [name, number] : before_.numbers) {
      const auto found = now_.numbers.find(name);
      if (found == now_.numbers.end()) {
        note_missing(name, number);
      } else {
        compare_numbers(name, number, found->second);
      }
    }
    for (const auto& [name, number] : now_.numbers) {
      if (before_.numbers.count(name) == 0) note_added(name, number);
    }
    if (same_platform_) compare_bits();
    return std::move(regressions_);
  }

  std::size_t unjudged() const { return unjudged_; }

 private:
  void compare_verdicts() {
    if (before_.verdict == now_.verdict) return;
    if (!same_platform_ && before_.perturbed_verdicts.count(now_.verdict) != 0) return;
    regressions_.push_back({.run = key_,
                            .metric = "verdict",
                            .before = name_of(before_.verdict),
                            .now = name_of(now_.verdict),
                            .why = now_.reason.empty() ? "the verdict of the run changed" : now_.reason,
                            .rule = Rule::verdict,
                            .change = change_between(before_.verdict, now_.verdict)});
  }

  void compare_numbers(const std::string& name, const BaselineNumber& before, const BaselineNumber& now) {
    compare_statuses(name, before, now);
    const bool bits_differ = !same(before, now);
    double times = 0;
    if (!before.bound) {
      if (!same_platform_) ++unjudged_;
    } else {
      times = times_bound(before, now);
    }
    if (times > 1) {
      regressions_.push_back({.run = key_,
                              .metric = name,
                              .before = with_unit(before.value, before.unit),
                              .now = with_unit(now.value, now.unit),
                              .tolerance = fmt::format("+/- {:.2g}", *before.bound),
                              .why = fmt::format("{:.3g} times the change that rounding explains", times),
                              .rule = Rule::bound,
                              .change = direction(name, before, now),
                              .times = times});
    }
    if (bits_differ) note_difference(name, before, now, times);
  }

  void compare_statuses(const std::string& name, const BaselineNumber& before, const BaselineNumber& now) {
    if (before.status == now.status || !before.status || !now.status) return;
    if (!same_platform_ && before.unstable) return;
    const auto text = [](const BaselineNumber& one) {
      return fmt::format("{} ({})", name_of(*one.status), with_unit(one.value, one.unit));
    };
    regressions_.push_back({.run = key_,
                            .metric = name,
                            .before = text(before),
                            .now = text(now),
                            .tolerance = with_unit(now.tolerance, now.unit),
                            .why = "the status of the check changed",
                            .rule = Rule::verdict,
                            .change = change_between(*before.status, *now.status),
                            .times = error_ratio(now.value, now.tolerance)});
  }

  void note_missing(const std::string& name, const BaselineNumber& before) {
    if (may_be_missing(before) && !std::isfinite(before.value)) return;
    note_difference(name, before, {}, 0);
    if (may_be_missing(before)) return;
    regressions_.push_back({.run = key_,
                            .metric = name,
                            .before = with_unit(before.value, before.unit),
                            .why = "it is no longer measured",
                            .rule = Rule::bound,
                            .change = Change::missing});
  }

  void note_added(const std::string& name, const BaselineNumber& now) {
    note_difference(name, {}, now, 0);
    regressions_.push_back({.run = key_,
                            .metric = name,
                            .now = with_unit(now.value, now.unit),
                            .why = "it was not measured before",
                            .rule = Rule::bound,
                            .change = Change::added});
  }

  // Counts differences of bits and remembers the largest.
  void note_difference(const std::string& name, const BaselineNumber& before, const BaselineNumber& now, double times) {
    if (differing_++ > 0 && times <= most_times_) return;
    most_times_ = times;
    most_ =
        same_number(before.value, now.value)
            ? fmt::format("{}: allowed {:.10g}, now {:.10g}", name, before.tolerance, now.tolerance)
            : fmt::format("{}: {}, now {}", name, with_unit(before.value, before.unit), with_unit(now.value, now.unit));
  }

  void compare_bits() {
    const bool both = !before_.bits.empty() && !now_.bits.empty();
    const bool trace_differs = both && before_.bits != now_.bits;
    if (!trace_differs && differing_ == 0) return;
    std::string why = !both           ? "numbers differ on the same platform"
                      : trace_differs ? "the trace differs on the same platform"
                                      : "the trace is the same, but it is measured or judged differently";
    if (differing_ == 0) {
      why += "; no number differs";
    } else if (differing_ == 1) {
      why += "; 1 number differs, " + most_;
    } else {
      why += fmt::format("; {} numbers differ, most of all {}", differing_, most_);
    }
    regressions_.push_back({.run = key_,
                            .metric = "bits",
                            .before = before_.bits,
                            .now = now_.bits,
                            .tolerance = "the same",
                            .why = why,
                            .rule = Rule::bits,
                            .times = most_times_});
  }

  const RunKey& key_;
  const BaselineRun& before_;
  const BaselineRun& now_;
  bool same_platform_;
  std::vector<Regression> regressions_;
  std::size_t unjudged_ = 0, differing_ = 0;
  double most_times_ = 0;
  std::string most_;
};

// "flags: -O3, was -O2; ..."; "" if there are none.
std::string differences(const std::map<std::string, std::string>& before,
                        const std::map<std::string, std::string>& now) {
  std::string text;
  const auto add = [&text](const std::string& name, const std::string& was, const std::string& is) {
    if (was != is) text += fmt::format("{}{}: {}, was {}", text.empty() ? "" : "; ", name, is, was);
  };
  for (const auto& [name, was] : before) add(name, was, now.count(name) != 0 ? now.at(name) : "unknown");
  for (const auto& [name, is] : now) {
    if (before.count(name) == 0) add(name, "unknown", is);
  }
  return text;
}

Regression presence(const RunKey& key, const BaselineRun& run, Change change) {
  const bool gone = change == Change::missing;
  return {.run = key,
          .metric = "run",
          .before = gone ? name_of(run.verdict) : "",
          .now = gone ? "" : name_of(run.verdict),
          .why = gone ? "only the baseline has this run" : "the baseline does not have this run",
          .rule = Rule::presence,
          .change = change};
}

std::string counted(const std::vector<Regression>& regressions) {
  std::string text;
  for (const Change change : {Change::worse, Change::missing, Change::changed, Change::better, Change::added}) {
    const auto count = std::count_if(regressions.begin(), regressions.end(),
                                     [&](const Regression& one) { return one.change == change; });
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(change));
  }
  return text;
}

std::string verdict_of(const GateResult& result, bool same_platform) {
  if (result.passed()) {
    return fmt::format("as accepted: {} run{}, {}", result.runs.size(), result.runs.size() == 1 ? "" : "s",
                       same_platform ? "to the bit" : "within what rounding explains on another platform");
  }
  std::set<RunKey> runs;
  for (const Regression& one : result.regressions) runs.insert(one.run);
  return fmt::format("NOT as accepted: {} of {} runs differ ({})", runs.size(), result.runs.size(),
                     counted(result.regressions));
}

// The run as an older Plumb would have told of it.
BaselineRun with_old_statuses(BaselineRun run) {
  for (auto& [name, number] : run.numbers) {
    if (number.status == CheckStatus::not_applicable) number.status = CheckStatus::not_reported;
  }
  return run;
}

}  // namespace

GateResult compare(const Baseline& before, const Baseline& now) {
  if (before.dt != now.dt && !before.runs.empty() && !now.runs.empty()) {
    throw std::invalid_argument(
        fmt::format("steps of {:.10g} s cannot be compared with steps of {:.10g} s; give --dt", now.dt, before.dt));
  }
  GateResult result;
  const std::string platform = differences(before.platform, now.platform);
  if (!platform.empty()) result.notes.push_back("Different platform (" + platform + ").");
  const std::string engines = differences(before.engines, now.engines);
  if (!engines.empty()) result.notes.push_back("Different engines (" + engines + ").");

  if (before.old_verdicts) {
    result.notes.push_back(
        "The baseline is of a version whose \"right\" included what is now coarse or no evidence, so verdicts may "
        "differ "
        "without a change of the physics; plumb accept makes it anew.");
  }

  const auto engine_of = [](const Baseline& baseline, const std::string& name) {
    const auto found = baseline.engines.find(name);
    return found == baseline.engines.end() ? "" : found->second;
  };
  std::size_t unjudged = 0;
  for (const auto& [key, run] : before.runs) {
    result.runs.push_back(key);
    const auto found = now.runs.find(key);
    if (found == now.runs.end()) {
      result.regressions.push_back(presence(key, run, Change::missing));
      continue;
    }
    const bool same = platform.empty() && engine_of(before, key.engine) == engine_of(now, key.engine);
    const BaselineRun now_run = before.old_statuses ? with_old_statuses(found->second) : found->second;
    RunComparison comparison(key, run, now_run, same);
    for (Regression& one : comparison.regressions()) result.regressions.push_back(std::move(one));
    unjudged += comparison.unjudged();
  }
  for (const auto& [key, run] : now.runs) {
    if (before.runs.count(key) != 0) continue;
    result.runs.push_back(key);
    result.regressions.push_back(presence(key, run, Change::added));
  }
  if (unjudged > 0) {
    result.notes.push_back(
        fmt::format("Not judged: {} number{} from another platform, for which the baseline has no bound.", unjudged,
                    unjudged == 1 ? "" : "s"));
  }
  sort(result.regressions);
  result.verdict = verdict_of(result, platform.empty() && engines.empty());
  return result;
}

GateResult compare(const Baseline& before, const Report& now) { return compare(before, baseline_of(now)); }

}  // namespace plumb
