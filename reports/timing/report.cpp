#include "reports/timing/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/statistics.h"
#include "reports/timing/google_benchmark.h"

namespace plumb {
namespace {

using TimingJson = google_benchmark::Json;

double median_of(const std::vector<double>& values) { return quartiles(values).median; }

std::string percent(double ratio) { return fmt::format("{:+.1f} %", 100 * (ratio - 1)); }

std::size_t count(const TimingReport& report, TimeChange change) {
  return static_cast<std::size_t>(std::count_if(report.cases.begin(), report.cases.end(),
                                                [&](const JudgedTime& one) { return one.change == change; }));
}

std::string verdict(const TimingReport& report) {
  const std::size_t slow = count(report, TimeChange::slower);
  const std::size_t none = count(report, TimeChange::no_result);
  std::string line =
      slow == 0 ? fmt::format("Times: no case takes longer than before by {:.1f} % or more", 100 * report.rule.least)
                : fmt::format("Times: {} of {} cases take longer than before", slow, report.cases.size());
  if (none > 0) line += fmt::format("; {} without a result", none);
  return line + ".\n";
}

// "stacking:ten    108.93 -> 114.40 us a step, +5.0 % (p = 3e-09, effect 1.00, 16 rounds)"
std::string line_of(const JudgedTime& one, const char* word) {
  const StepCosts& before = one.pair.before;
  const StepCosts& now = one.pair.now;
  constexpr double micro = 1e6;
  std::string text =
      fmt::format("  {:<10}{:<32}{:>10.4g} -> {:>10.4g} us a step, {} (p = {:.1g}, effect {:.2f}, {} rounds", word,
                  one.pair.name, micro * median_of(before.cpu), micro * median_of(now.cpu), percent(one.time.ratio),
                  one.time.p, one.time.effect, now.cpu.size());
  if (one.instructions) text += fmt::format(", instructions {}", percent(one.instructions->ratio));
  if (one.pair.steps < one.pair.of) text += fmt::format(", first {} of {} steps", one.pair.steps, one.pair.of);
  return text + ")\n";
}

std::string lines_of(const TimingReport& report, TimeChange change, const char* word) {
  std::string text;
  for (const JudgedTime& one : report.cases) {
    if (one.change != change) continue;
    text += change == TimeChange::no_result ? fmt::format("  {:<10}{:<32}{}\n", word, one.pair.name, one.pair.no_result)
                                            : line_of(one, word);
  }
  return text;
}

TimingJson values_of(const TimingReport& report) {
  return {{"program_before", report.program_before},
          {"program_now", report.program_now},
          {"facts_before", report.facts_before},
          {"facts_now", report.facts_now},
          {"load_after", report.load_after},
          {"instructions_not_counted", report.uncounted},
          {"least", report.rule.least}};
}

void add_entries(TimingJson& all, const JudgedTime& one, const char* side, const StepCosts& cost) {
  const std::string name = fmt::format("{}/{}", side, one.pair.name);
  const auto rounds = static_cast<int>(cost.cpu.size());
  const auto entry = [&](const char* type) {
    return google_benchmark::entry(name, type, rounds, 1, std::max<std::size_t>(one.pair.steps, 1));
  };
  if (!one.pair.no_result.empty()) {
    TimingJson failed = entry("iteration");
    google_benchmark::add_error(failed, one.pair.no_result);
    all.push_back(failed);
    return;
  }
  const bool counted = cost.instructions.size() == cost.cpu.size();
  for (std::size_t i = 0; i < cost.cpu.size(); ++i) {
    TimingJson round = entry("iteration");
    round["repetition_index"] = i;
    google_benchmark::add_times(round, cost.wall[i], cost.cpu[i]);
    if (counted) round["INSTRUCTIONS"] = cost.instructions[i];
    all.push_back(round);
  }
  TimingJson middle = entry("aggregate");
  google_benchmark::name_median(middle);
  google_benchmark::add_times(middle, median_of(cost.wall), median_of(cost.cpu));
  if (counted) middle["INSTRUCTIONS"] = median_of(cost.instructions);
  all.push_back(middle);
}

}  // namespace

std::string timing_text(const TimingReport& report) {
  std::string text = verdict(report);
  text += lines_of(report, TimeChange::slower, "slower") + lines_of(report, TimeChange::faster, "faster") +
          lines_of(report, TimeChange::no_result, "no result");
  const TimingFacts& now = report.facts_now;
  text += fmt::format(
      "  {}, {} processors, governor {}, load {} to {}{}. {}.\n", fact(now, "processor"), fact(now, "processors"),
      fact(now, "governor"), fact(now, "load"), report.load_after, busy(now) ? ": busy" : "",
      report.uncounted.empty() ? "Instructions are compared too" : "Instructions are not counted: " + report.uncounted);
  for (const std::string& difference : build_differences(report.facts_before, now))
    text += fmt::format("  built differently: {}\n", difference);
  return text;
}

std::string timing_json(const TimingReport& report) {
  TimingJson all = TimingJson::array();
  for (const JudgedTime& one : report.cases) {
    add_entries(all, one, "before", one.pair.before);
    add_entries(all, one, "now", one.pair.now);
  }
  return google_benchmark::text_of(std::move(all), values_of(report));
}

}  // namespace plumb
