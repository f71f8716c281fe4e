#include "reports/timing/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/statistics.h"
#include "reports/timing/google_benchmark.h"

namespace plumb {
namespace {

using google_benchmark::Json;

double median(const std::vector<double>& values) { return quartiles(values).median; }

std::string percent(double ratio) { return fmt::format("{:+.1f} %", 100 * (ratio - 1)); }

std::size_t count(const TimingReport& report, Pace pace) {
  return static_cast<std::size_t>(
      std::count_if(report.cases.begin(), report.cases.end(), [&](const JudgedTime& one) { return one.pace == pace; }));
}

std::string verdict(const TimingReport& report) {
  const std::size_t slow = count(report, Pace::slower);
  const std::size_t none = count(report, Pace::no_result);
  std::string line =
      slow == 0 ? fmt::format("Times: nothing takes longer than before, by {:.1f} % or more", 100 * report.rule.least)
                : fmt::format("Times: {} of {} take longer than before", slow, report.cases.size());
  if (none > 0) line += fmt::format("; {} without a result", none);
  return line + ".\n";
}

// "stacking:ten    108.93 -> 114.40 us a step, +5.0 % (p = 3e-09, effect 1.00, 16 sittings)"
std::string line_of(const JudgedTime& one, const char* word) {
  const Cost& before = one.pair.before;
  const Cost& now = one.pair.now;
  constexpr double micro = 1e6;
  std::string text =
      fmt::format("  {:<10}{:<32}{:>10.4g} -> {:>10.4g} us a step, {} (p = {:.1g}, effect {:.2f}, {} sittings", word,
                  one.pair.name, micro * median(before.cpu), micro * median(now.cpu), percent(one.time.ratio),
                  one.time.p, one.time.effect, now.cpu.size());
  if (one.instructions) text += fmt::format(", instructions {}", percent(one.instructions->ratio));
  if (one.pair.steps < one.pair.of) text += fmt::format(", first {} of {} steps", one.pair.steps, one.pair.of);
  return text + ")\n";
}

std::string lines(const TimingReport& report, Pace pace, const char* word) {
  std::string text;
  for (const JudgedTime& one : report.cases) {
    if (one.pace != pace) continue;
    text += pace == Pace::no_result ? fmt::format("  {:<10}{:<32}{}\n", word, one.pair.name, one.pair.no_result)
                                    : line_of(one, word);
  }
  return text;
}

Json values_of(const TimingReport& report) {
  return {{"program_before", report.program_before},
          {"program_now", report.program_now},
          {"facts_before", report.facts_before},
          {"facts_now", report.facts_now},
          {"load_after", report.load_after},
          {"instructions_not_counted", report.uncounted},
          {"least", report.rule.least}};
}

void add(Json& all, const JudgedTime& one, const char* side, const Cost& cost) {
  const std::string name = fmt::format("{}/{}", side, one.pair.name);
  const auto sittings = static_cast<int>(cost.cpu.size());
  const auto entry = [&](const char* type) {
    return google_benchmark::entry(name, type, sittings, 1, std::max<std::size_t>(one.pair.steps, 1));
  };
  if (!one.pair.no_result.empty()) {
    Json failed = entry("iteration");
    google_benchmark::add_error(failed, one.pair.no_result);
    all.push_back(failed);
    return;
  }
  const bool counted = cost.instructions.size() == cost.cpu.size();
  for (std::size_t i = 0; i < cost.cpu.size(); ++i) {
    Json sitting = entry("iteration");
    sitting["repetition_index"] = i;
    google_benchmark::add_times(sitting, cost.wall[i], cost.cpu[i]);
    if (counted) sitting["INSTRUCTIONS"] = cost.instructions[i];
    all.push_back(sitting);
  }
  Json middle = entry("aggregate");
  google_benchmark::name_median(middle);
  google_benchmark::add_times(middle, median(cost.wall), median(cost.cpu));
  if (counted) middle["INSTRUCTIONS"] = median(cost.instructions);
  all.push_back(middle);
}

}  // namespace

std::string timing_text(const TimingReport& report) {
  std::string text = verdict(report);
  text += lines(report, Pace::slower, "slower") + lines(report, Pace::faster, "faster") +
          lines(report, Pace::no_result, "no result");
  const TimingFacts& now = report.facts_now;
  text += fmt::format("  {}, {} processors, governor {}, load {} to {}{}. {}.\n", fact(now, "processor"),
                      fact(now, "processors"), fact(now, "governor"), fact(now, "load"), report.load_after,
                      busy(now) ? ": busy" : "",
                      report.uncounted.empty() ? "Instructions are compared as well"
                                               : "Instructions are not counted: " + report.uncounted);
  for (const std::string& difference : built_otherwise(report.facts_before, now))
    text += fmt::format("  built otherwise: {}\n", difference);
  return text;
}

std::string timing_json(const TimingReport& report) {
  Json all = Json::array();
  for (const JudgedTime& one : report.cases) {
    add(all, one, "before", one.pair.before);
    add(all, one, "now", one.pair.now);
  }
  return google_benchmark::text_of(std::move(all), values_of(report));
}

}  // namespace plumb
