#include "reports/gate/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reports/judge/metric.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

// What may be believed the less the higher it stands. What cannot be told to its end is as plausible as another run of
// it would be; to refuse is honest, to be wrong is not.
int rank(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return 0;
    case Verdict::plausible:
    case Verdict::beyond_horizon:
      return 1;
    case Verdict::not_supported:
      return 2;
    case Verdict::wrong:
      return 3;
    case Verdict::failed:
      return 4;
  }
  return 4;
}

int rank(CheckStatus status) {
  switch (status) {
    case CheckStatus::held:
      return 0;
    case CheckStatus::not_reported:
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

// A file tells no infinity from what is no number.
bool same_number(double a, double b) { return a == b || (!std::isfinite(a) && !std::isfinite(b)); }

// Stands for what only starts next to this one have, or what may be gone on another platform.
bool comes_and_goes(const KeptNumber& number) { return number.moves == infinity; }

bool same(const KeptNumber& a, const KeptNumber& b) {
  return same_number(a.value, b.value) && same_number(a.tolerance, b.tolerance) && a.status == b.status;
}

std::string in_words(double value, const std::string& unit) {
  return fmt::format("{:.10g}{}", value, unit.empty() || unit == "1" ? "" : " " + unit);
}

double share_of(double value, double allowed) {
  const double share = value / allowed;
  if (!std::isfinite(share)) return infinity;
  return share;
}

// How many times farther apart than they may be; 0 where both are the same, or nothing at all.
double times_moved(const KeptNumber& before, const KeptNumber& now) {
  if (*before.moves == infinity || same_number(before.value, now.value)) return 0;
  const double apart = std::abs(now.value - before.value);
  if (!std::isfinite(apart)) return infinity;
  return *before.moves > 0 ? apart / *before.moves : infinity;
}

// Checks tell how far something is off; what a metric's direction means, it says itself.
Change direction(const std::string& name, const KeptNumber& before, const KeptNumber& now) {
  const Metric* metric = Catalog<Metric>::find(name);
  const Better better = before.status ? Better::lower : metric == nullptr ? Better::neither : metric->better;
  if (better == Better::neither) return Change::changed;
  if (std::isfinite(before.value) != std::isfinite(now.value))
    return std::isfinite(now.value) ? Change::better : Change::worse;
  const bool higher = now.value > before.value;
  return higher == (better == Better::lower) ? Change::worse : Change::better;
}

// One run against what it was.
class RunComparison {
 public:
  RunComparison(const RunKey& key, const KeptRun& before, const KeptRun& now, bool same_platform)
      : key_(key), before_(before), now_(now), same_platform_(same_platform) {}

  std::vector<Regression> regressions() {
    compare_verdicts();
    // What did not come to its end has nothing to measure.
    if (now_.numbers.empty() || before_.numbers.empty()) {
      if (same_platform_) compare_bits();
      return std::move(regressions_);
    }
    for (const auto& [name, number] : before_.numbers) {
      const auto found = now_.numbers.find(name);
      if (found == now_.numbers.end()) {
        gone(name, number);
      } else {
        compare_numbers(name, number, found->second);
      }
    }
    for (const auto& [name, number] : now_.numbers) {
      if (before_.numbers.count(name) == 0) come(name, number);
    }
    if (same_platform_) compare_bits();
    return std::move(regressions_);
  }

  std::size_t unjudged() const { return unjudged_; }

 private:
  void compare_verdicts() {
    if (before_.verdict == now_.verdict) return;
    if (!same_platform_ && before_.neighbours.count(now_.verdict) != 0) return;
    regressions_.push_back({.run = key_,
                            .metric = "verdict",
                            .before = name_of(before_.verdict),
                            .now = name_of(now_.verdict),
                            .why = now_.reason.empty() ? "what physics says of the run is another" : now_.reason,
                            .rule = Rule::verdict,
                            .change = change_between(before_.verdict, now_.verdict)});
  }

  void compare_numbers(const std::string& name, const KeptNumber& before, const KeptNumber& now) {
    compare_standings(name, before, now);
    const bool bits_differ = !same(before, now);
    double times = 0;
    if (!before.moves) {
      if (!same_platform_) ++unjudged_;
    } else {
      times = times_moved(before, now);
    }
    if (times > 1) {
      regressions_.push_back({.run = key_,
                              .metric = name,
                              .before = in_words(before.value, before.unit),
                              .now = in_words(now.value, now.unit),
                              .tolerance = fmt::format("{:.2g}", *before.moves) + " off",
                              .why = fmt::format("{:.3g} times farther off than rounding explains", times),
                              .rule = Rule::bound,
                              .change = direction(name, before, now),
                              .times = times});
    }
    if (bits_differ) differ(name, before, now, times);
  }

  void compare_standings(const std::string& name, const KeptNumber& before, const KeptNumber& now) {
    if (before.status == now.status || !before.status || !now.status) return;
    if (!same_platform_ && before.wavers) return;
    const auto words = [](const KeptNumber& one) {
      return fmt::format("{} ({})", name_of(*one.status), in_words(one.value, one.unit));
    };
    regressions_.push_back({.run = key_,
                            .metric = name,
                            .before = words(before),
                            .now = words(now),
                            .tolerance = in_words(now.tolerance, now.unit),
                            .why = "what was held to is another",
                            .rule = Rule::verdict,
                            .change = change_between(*before.status, *now.status),
                            .times = share_of(now.value, now.tolerance)});
  }

  void gone(const std::string& name, const KeptNumber& before) {
    if (comes_and_goes(before) && !std::isfinite(before.value)) return;
    differ(name, before, {}, 0);
    if (comes_and_goes(before)) return;
    regressions_.push_back({.run = key_,
                            .metric = name,
                            .before = in_words(before.value, before.unit),
                            .why = "it is no longer measured",
                            .rule = Rule::bound,
                            .change = Change::missing});
  }

  void come(const std::string& name, const KeptNumber& now) {
    differ(name, {}, now, 0);
    regressions_.push_back({.run = key_,
                            .metric = name,
                            .now = in_words(now.value, now.unit),
                            .why = "it was not measured before",
                            .rule = Rule::bound,
                            .change = Change::added});
  }

  // Remembers the number that differs the most.
  void differ(const std::string& name, const KeptNumber& before, const KeptNumber& now, double times) {
    if (differing_++ > 0 && times <= most_times_) return;
    most_times_ = times;
    most_ =
        same_number(before.value, now.value)
            ? fmt::format("{}: allowed {:.10g}, now {:.10g}", name, before.tolerance, now.tolerance)
            : fmt::format("{}: {}, now {}", name, in_words(before.value, before.unit), in_words(now.value, now.unit));
  }

  void compare_bits() {
    const bool both = !before_.bits.empty() && !now_.bits.empty();
    const bool trace = both && before_.bits != now_.bits;
    if (!trace && differing_ == 0) return;
    std::string why = trace ? "the same platform gave other bits" : "the same trace is measured or judged otherwise";
    if (!both) why = "the same platform gave other numbers";
    why += differing_ == 0 ? "; no number of it differs"
                           : fmt::format("; {} number{} of it differ{}, {}", differing_, differing_ == 1 ? "" : "s",
                                         differing_ == 1 ? "s" : "", most_);
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
  const KeptRun& before_;
  const KeptRun& now_;
  bool same_platform_;
  std::vector<Regression> regressions_;
  std::size_t unjudged_ = 0, differing_ = 0;
  double most_times_ = 0;
  std::string most_;
};

// "flags: -O3, was -O2; ..."; "" for the same.
std::string differences(const std::map<std::string, std::string>& before,
                        const std::map<std::string, std::string>& now) {
  std::string text;
  const auto see = [&text](const std::string& name, const std::string& was, const std::string& is) {
    if (was != is) text += fmt::format("{}{}: {}, was {}", text.empty() ? "" : "; ", name, is, was);
  };
  for (const auto& [name, was] : before) see(name, was, now.count(name) != 0 ? now.at(name) : "unknown");
  for (const auto& [name, is] : now) {
    if (before.count(name) == 0) see(name, "unknown", is);
  }
  return text;
}

Regression presence(const RunKey& key, const KeptRun& run, Change change) {
  const bool gone = change == Change::missing;
  return {.run = key,
          .metric = "run",
          .before = gone ? name_of(run.verdict) : "",
          .now = gone ? "" : name_of(run.verdict),
          .why = gone ? "it was there when the baseline was accepted" : "the baseline does not know it",
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

}  // namespace

GateResult compare(const Baseline& before, const Baseline& now) {
  if (before.dt != now.dt && !before.runs.empty() && !now.runs.empty()) {
    throw std::invalid_argument(
        fmt::format("steps of {:.10g} s cannot be compared with steps of {:.10g} s; give --dt", now.dt, before.dt));
  }
  GateResult result;
  const std::string platform = differences(before.platform, now.platform);
  if (!platform.empty()) result.notes.push_back("Another platform (" + platform + ").");
  const std::string engines = differences(before.engines, now.engines);
  if (!engines.empty()) result.notes.push_back("Other engines (" + engines + ").");

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
    RunComparison comparison(key, run, found->second, same);
    for (Regression& one : comparison.regressions()) result.regressions.push_back(std::move(one));
    unjudged += comparison.unjudged();
  }
  for (const auto& [key, run] : now.runs) {
    if (before.runs.count(key) != 0) continue;
    result.runs.push_back(key);
    result.regressions.push_back(presence(key, run, Change::added));
  }
  if (unjudged > 0) {
    result.notes.push_back(fmt::format(
        "{} numbers are of another platform, and nobody said how far they may move: they are not judged.", unjudged));
  }
  sort(result.regressions);
  result.verdict = verdict_of(result, platform.empty() && engines.empty());
  return result;
}

GateResult compare(const Baseline& before, const Report& now) { return compare(before, baseline_of(now)); }

}  // namespace plumb
