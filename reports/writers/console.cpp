#include "reports/writers/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/system/layout.h"
#include "reports/writers/summary.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

constexpr std::size_t most_failures = 3;  // failed checks of a run; the files have them all

const char* colour_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "\033[32m";
    case Verdict::coarse:
    case Verdict::plausible:
    case Verdict::no_evidence:
    case Verdict::beyond_horizon:
      return "\033[33m";
    case Verdict::wrong:
    case Verdict::failed:
      return "\033[31m";
    case Verdict::not_supported:
      return "\033[2m";
  }
  return "";
}

std::string number(const std::map<std::string, Measured>& metrics, const char* name) {
  const auto found = metrics.find(name);
  return found == metrics.end() ? "-" : fmt::format("{:.3g}", found->second.value);
}

std::string step_cost(const Report& report, const RunRecord& run) {
  for (const Timing& timing : report.timings) {
    const bool same = timing.scenario == run.scenario && timing.variant == run.variant && timing.engine == run.engine &&
                      timing.method == run.method;
    if (same) return fmt::format("{:.3g}", timing.step_us);
  }
  return "-";
}

std::string passed(const RunRecord& run) {
  const auto reported =
      std::count_if(run.truth.begin(), run.truth.end(), [](const auto& check) { return check.reported; });
  if (reported == 0) return "-";
  const auto count = std::count_if(run.truth.begin(), run.truth.end(), [](const auto& check) { return check.passed; });
  return fmt::format("{}/{}", count, reported);
}

// The largest error / tolerance.
std::string worst(const RunRecord& run) {
  const auto ratio = worst_error_ratio(run);
  return ratio ? fmt::format("{:.3g}", *ratio) : "-";
}

// The largest error / scale, in percent.
std::string farthest(const RunRecord& run) {
  const auto relative = worst_relative_error(run);
  return relative ? percent(*relative) : "-";
}

// The error estimate of a converged reference.
std::string exactness(const RunRecord& run) {
  if (!run.exact) return "";
  const auto estimate = run.metrics.find("truth_estimate_max");
  return estimate == run.metrics.end() ? " (exact)" : fmt::format(" (+- {:.1g} m)", estimate->second.value);
}

// How an engine's code runs, unless that is native.
std::string mark_of(const Report& report, const RunRecord& run) {
  const auto note = std::ranges::find(report.engines, run.engine, &EngineNote::name);
  return note == report.engines.end() ? "" : execution_mark(name_of(note->execution));
}

bool same_case(const RunRecord& a, const RunRecord& b) { return a.scenario == b.scenario && a.variant == b.variant; }

bool same_case(const Comparison& a, const RunRecord& b) { return a.scenario == b.scenario && a.variant == b.variant; }

// The check whose error is largest by the scale.
const TruthCheck* farthest_check(const RunRecord& run) {
  const TruthCheck* farthest = nullptr;
  for (const TruthCheck& check : run.truth) {
    const bool more = farthest == nullptr || relative_error(check) > relative_error(*farthest);
    if (check.reported && more) farthest = &check;
  }
  return farthest;
}

std::string tolerance_of(const RunRecord& run) {
  const TruthCheck* check = farthest_check(run);
  return check == nullptr || check->scale <= 0 ? "-" : percent(check->tolerance / check->scale);
}

// What a run is compared with in energy and position: the truth, or else the first engine of the case.
const KeyDifferences* differences_of(const Report& report, const RunRecord& run) {
  const std::string label = label_of(run.engine, run.method);
  const KeyDifferences* from_first = nullptr;
  for (const Comparison& one : report.comparisons) {
    if (!same_case(one, run) || !one.key) continue;
    const bool with_truth = std::ranges::any_of(report.runs, [&](const RunRecord& other) {
      return other.exact && same_case(other, run) && other.engine == one.b;
    });
    if (with_truth && one.a == label) return &*one.key;
    if (!with_truth && one.b == label && from_first == nullptr) from_first = &*one.key;
  }
  return from_first;
}

std::string differs_at(const KeyDifferences* differences) {
  if (differences == nullptr) return "-";
  return differences->diverged_at ? short_number(differences->diverged_at) : "never";
}

std::string failures_of(const RunRecord& run, const ConsoleOptions& options) {
  constexpr std::size_t indent = 6;
  std::string text;
  if (!run.reason.empty()) text += wrapped(run.reason, indent, options.width);
  const std::size_t most = options.verbose ? run.truth.size() : most_failures;
  std::size_t failed = 0;
  for (const TruthCheck& check : run.truth) {
    if (!check.passed && ++failed <= most) text += wrapped(in_words(check), indent, options.width);
  }
  if (failed > most) text += wrapped(fmt::format("and {} more (--verbose)", failed - most), indent, options.width);
  for (const InvariantCheck& check : run.invariants) {
    if (check.status == CheckStatus::broken) text += wrapped(in_words(check), indent, options.width);
  }
  return text;
}

void add_row(const Report& report, const RunRecord& run, const ConsoleOptions& options, TextTable& table) {
  const KeyDifferences* differences = differences_of(report, run);
  table.add({{"  " + label_of(run.engine, run.method) + exactness(run) + mark_of(report, run)},
             {name_of(run.verdict), options.colour ? colour_of(run.verdict) : ""},
             {passed(run)},
             {farthest(run)},
             {tolerance_of(run)},
             {worst(run)},
             {differs_at(differences)},
             {number(run.metrics, "time_to_rest")},
             {differences == nullptr ? "-" : percent(differences->energy.largest)},
             {number(run.metrics, "penetration_max")},
             {step_cost(report, run)}});
  table.add_lines(failures_of(run, options));
}

std::string in_words(const Comparison& comparison) {
  if (comparison.metrics.empty()) return "";
  const auto of = [&](const char* name) { return number(comparison.metrics, name); };
  std::string text = fmt::format("{} - {}: up to {} m apart, {} m at the end", comparison.a, comparison.b,
                                 of("position_difference_max"), of("position_difference_end"));
  if (comparison.key) text += fmt::format("; energy up to {} % of scale", percent(comparison.key->energy.largest));
  if (comparison.metrics.count("horizon") != 0) text += "; " + comparison.reason;
  if (comparison.key && comparison.key->diverged_at) {
    text += fmt::format("; diverged at {:.3g} s", *comparison.key->diverged_at);
  }
  return text;
}

// All engines of a case, each two of them. Comparisons with the truth are in the table.
std::string pairs_of(const Report& report, const RunRecord& first, std::size_t width) {
  std::string text;
  for (const Comparison& one : report.comparisons) {
    const bool with_truth = std::ranges::any_of(
        report.runs, [&](const RunRecord& run) { return run.exact && same_case(run, first) && run.engine == one.b; });
    if (same_case(one, first) && !with_truth) text += wrapped(in_words(one), 4, width);
  }
  return text;
}

std::string scenario_table(const Report& report, const std::string& scenario, const ConsoleOptions& options) {
  TextTable table({{"  engine", 0, true},
                   {"verdict", 0, true},
                   {"checks", 8},
                   {"error %"},
                   {"tol. %", 5},
                   {"/ tol."},
                   {"differs", 2},
                   {"rest", 4},
                   {"energy %", 3},
                   {"overlap", 6},
                   {"us/step", 7}},
                  0, options.width);
  const RunRecord* before = nullptr;
  for (const RunRecord& run : report.runs) {
    if (run.scenario != scenario) continue;
    const bool begins = before == nullptr || before->variant != run.variant;
    if (begins && before != nullptr && options.verbose) table.add_lines(pairs_of(report, *before, options.width));
    if (begins && !run.variant.empty()) table.add_lines(wrapped(run.variant, 0, options.width));
    add_row(report, run, options, table);
    before = &run;
  }
  if (before != nullptr && options.verbose) table.add_lines(pairs_of(report, *before, options.width));
  return table.text();
}

// One row a case for the first two engines. The files and the page have all pairs.
std::string key_table(const Report& report, std::size_t width) {
  const auto pair = first_pair(report);
  if (!pair) return "";
  const auto rows = comparisons_of(report, *pair);
  TextTable table({{"case", 0, true},
                   {"energy, %"},
                   {"momentum, %", 2},
                   {"angular, %", 4},
                   {"rest a, s", 1},
                   {"rest b, s", 1},
                   {"overlap a, m", 3},
                   {"overlap b, m", 3},
                   {"differ, s"}},
                  0, width);
  for (const Comparison* one : rows) {
    const std::string name = one->scenario + (one->variant.empty() ? "" : ":" + one->variant);
    if (!one->key) {
      table.add_lines(beside(name, 14, one->reason, width));
      continue;
    }
    const KeyDifferences& key = *one->key;
    table.add({{name},
               {percent(key.energy.largest)},
               {percent(key.momentum.largest)},
               {percent(key.angular_momentum.largest)},
               {short_number(key.rest_a)},
               {short_number(key.rest_b)},
               {short_number(key.overlap_a)},
               {short_number(key.overlap_b)},
               {key.diverged_at ? short_number(key.diverged_at) : "never"}});
  }
  return wrapped(fmt::format("a: {}, b: {}", pair->a, pair->b), 0, width) + table.text() +
         wrapped(in_one_sentence(*pair, rows), 0, width) + "\n";
}

constexpr const char* legend =
    "error: the farthest from the truth, and its tolerance, in % of scale; / tol.: the largest error / tolerance, "
    "above "
    "1 is wrong; differs: when first 1 cm from the truth, or else from the first engine, s, and energy: the largest "
    "difference, in % of scale; rest: since when, s; overlap: the deepest, m. plumb help WORD explains a word.";

std::string in_words(const EngineSummary& one, std::size_t width) {
  std::string line = one.engine + ":";
  for (const auto& [verdict, count] : one.verdicts) line += fmt::format(" {} {},", count, name_of(verdict));
  line.pop_back();
  if (one.checks > 0) {
    line += fmt::format("; of {} checks {} within 1 % of scale, {} within 0.01 %; not a test: {} checks, {} of {} laws",
                        one.checks, share_of(one.within[1], one.checks), share_of(one.within[3], one.checks),
                        one.untested, one.untested_laws, one.laws);
  }
  return wrapped(line, 0, width);
}

// "impulse, images alike within 0.01 % of scale: shift 100 % of 12, 1 broken; mirror 91 % of 12"
std::string relations_text(const Report& report, std::size_t width) {
  std::vector<std::pair<std::string, std::string>> lines;  // by engine
  for (const RelationSummary& one : relation_summaries(report)) {
    const bool first = lines.empty() || lines.back().first != one.engine;
    if (first) lines.emplace_back(one.engine, one.engine + ", images alike within 0.01 % of scale: ");
    lines.back().second +=
        fmt::format("{}{} {} of {}", first ? "" : "; ", one.relation, share_of(one.alike, one.cases), one.cases);
    if (one.broken > 0) lines.back().second += fmt::format(", {} broken", one.broken);
  }
  std::string text;
  for (const auto& [engine, line] : lines) text += wrapped(line, 0, width);
  return text;
}

std::string quoted_if_needed(const std::string& word) {
  return word.find(' ') == std::string::npos ? word : "'" + word + "'";
}

// How to find out why a run is wrong, of the first such engine that a command line names by its name; "" if there is
// none.
std::string why_text(const Report& report, std::size_t width) {
  for (const RunRecord& run : report.runs) {
    if (run.exact || run.verdict != Verdict::wrong) continue;
    const auto note = std::ranges::find(report.engines, run.engine, &EngineNote::name);
    const bool by_name = note == report.engines.end() || note->word.empty() || note->word == run.engine;
    const bool closed_form = std::ranges::any_of(report.runs, [&](const RunRecord& other) {
      return other.exact && same_case(other, run) && other.metrics.count("truth_estimate_max") == 0;
    });
    const std::string label = label_of(run.engine, run.method);
    const std::string other = closed_form ? "exact" : "impulse";
    if (!by_name || label == other) continue;
    const std::string name = run.variant.empty()              ? run.scenario
                             : run.variant.ends_with(".json") ? run.variant
                                                              : run.scenario + ":" + run.variant;
    return wrapped(fmt::format("Why? plumb diff {} {} {} finds the first step that differs; plumb show {} says what it "
                               "does differently.",
                               quoted_if_needed(name), other, quoted_if_needed(label), quoted_if_needed(run.engine)),
                   0, width);
  }
  return "";
}

// Programs that bear another name than they say, because another program bears that.
std::string renamed_text(const Report& report, std::size_t width) {
  std::string text;
  for (const EngineNote& one : report.engines) {
    if (one.name.find('@') != std::string::npos)
      text += wrapped(one.name + " is " + printable(one.word, 400), 0, width);
  }
  return text;
}

}  // namespace

std::string console_text(const Report& report, const ConsoleOptions& options) {
  std::string text;
  std::set<std::string> shown;
  for (const RunRecord& run : report.runs) {
    if (!shown.insert(run.scenario).second) continue;
    const auto note =
        std::ranges::find_if(report.scenarios, [&](const ScenarioNote& one) { return one.name == run.scenario; });
    text += wrapped(run.scenario + (note == report.scenarios.end() ? "" : ": " + note->question), 0, options.width);
    text += scenario_table(report, run.scenario, options) + "\n";
  }
  if (!report.runs.empty()) text += wrapped(legend, 0, options.width) + "\n";
  text += key_table(report, options.width);
  for (const EngineSummary& one : engine_summaries(report)) text += in_words(one, options.width);
  return text + relations_text(report, options.width) + renamed_text(report, options.width) +
         why_text(report, options.width);
}

}  // namespace plumb
