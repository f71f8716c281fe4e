#include "reports/writers/console.h"
#include "reports/writers/in_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "reports/writers/in_words.h"
#include "reports/writers/summary.h"

namespace plumb {
namespace {

constexpr std::size_t console_width = 100;  // columns
constexpr std::size_t most_failures = 3;    // failed checks of a run; the files have them all

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

// Padded before colouring: escape sequences take no columns.
std::string painted(Verdict verdict, std::size_t columns, bool colour) {
  const std::string text = fmt::format("{:<{}}", name_of(verdict), columns);
  return colour ? colour_of(verdict) + text + "\033[0m" : text;
}

std::string cut(const std::string& text, std::size_t columns) {
  return text.size() <= columns ? text : text.substr(0, columns - 3) + "...";
}

// Breaks text into indented lines of at most `console_width` columns; a word too long for a line is broken.
std::string wrapped(const std::string& text, std::size_t indent) {
  const std::size_t room = console_width - indent;
  std::istringstream words(text);
  std::string lines;
  std::string line;
  const auto flush = [&] {
    lines += std::string(indent, ' ') + line + '\n';
    line.clear();
  };
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > room) flush();
    for (; word.size() > room; word.erase(0, room)) {
      line = word.substr(0, room);
      flush();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) flush();
  return lines;
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

std::string table_row(const std::string& engine, const std::string& verdict, const std::string& checks,
                      const std::string& relative, const std::string& worst, const std::string& error,
                      const std::string& overlap, const std::string& cost) {
  return fmt::format("    {:<27}{}{:>8}{:>9}{:>10}{:>10}{:>11}{:>8}\n", cut(engine, 26), verdict, checks, relative,
                     worst, error, overlap, cost);
}

// The error estimate of a converged reference.
std::string exactness(const RunRecord& run) {
  if (!run.exact) return "";
  const auto estimate = run.metrics.find("truth_estimate_max");
  return estimate == run.metrics.end() ? " (exact)" : fmt::format(" (+- {:.1g} m)", estimate->second.value);
}

std::string row(const Report& report, const RunRecord& run, bool colour) {
  std::string text = table_row(label_of(run.engine, run.method) + exactness(run), painted(run.verdict, 13, colour),
                               passed(run), farthest(run), worst(run), number(run.metrics, "truth_error_end"),
                               number(run.metrics, "penetration_max"), step_cost(report, run));
  if (!run.reason.empty()) text += wrapped(run.reason, 8);
  std::size_t failed = 0;
  for (const TruthCheck& check : run.truth) {
    if (!check.passed && ++failed <= most_failures) text += wrapped(in_words(check), 8);
  }
  if (failed > most_failures) text += wrapped(fmt::format("and {} more", failed - most_failures), 8);
  for (const InvariantCheck& check : run.invariants) {
    if (check.status == CheckStatus::broken) text += wrapped(in_words(check), 8);
  }
  return text;
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

// The runs of a case, then the comparisons of the first engine with the others. The files have all pairs.
std::string case_text(const Report& report, const RunRecord& first, bool colour) {
  std::string text = wrapped(first.variant, 2);
  text += table_row("engine", fmt::format("{:<13}", "verdict"), "checks", "off, %", "/ tol.", "error, m", "overlap, m",
                    "us/step");
  const auto same = [&](const auto& one) { return one.scenario == first.scenario && one.variant == first.variant; };
  for (const RunRecord& run : report.runs) {
    if (same(run)) text += row(report, run, colour);
  }
  const auto lead = std::find_if(report.runs.begin(), report.runs.end(),
                                 [&](const RunRecord& run) { return !run.exact && same(run); });
  for (const Comparison& comparison : report.comparisons) {
    const bool with_truth = std::any_of(report.runs.begin(), report.runs.end(), [&](const RunRecord& run) {
      return run.exact && same(run) && run.engine == comparison.b;
    });
    const bool leads = lead != report.runs.end() && comparison.a == label_of(lead->engine, lead->method);
    if (same(comparison) && leads && !with_truth) text += wrapped(in_words(comparison), 4);
  }
  return text;
}

std::string key_row(const Comparison& one) {
  const std::string name = cut(one.scenario + (one.variant.empty() ? "" : ":" + one.variant), 29);
  if (!one.key) return fmt::format("{:<30}{}\n", name, cut(one.reason, console_width - 30));
  const KeyDifferences& key = *one.key;
  return fmt::format("{:<30}{:>9}{:>9}{:>9}{:>8}{:>8}{:>9}{:>9}{:>9}\n", name, percent(key.energy.largest),
                     percent(key.momentum.largest), percent(key.angular_momentum.largest), short_number(key.rest_a),
                     short_number(key.rest_b), short_number(key.overlap_a), short_number(key.overlap_b),
                     short_number(key.diverged_at));
}

// One row a case for the first two engines. The files and the page have all pairs.
std::string key_table(const Report& report) {
  const auto pair = first_pair(report);
  if (!pair) return "";
  const auto rows = comparisons_of(report, *pair);
  std::string text = wrapped(fmt::format("a: {}, b: {}", pair->a, pair->b), 0);
  text += wrapped(
      "energy, momentum, angular momentum: the largest difference in % of the scene's scale; rest: since when, s; "
      "overlap: the deepest, m; 1 cm at: when they were first so far apart, s",
      0);
  text += fmt::format("{:<30}{:>9}{:>9}{:>9}{:>8}{:>8}{:>9}{:>9}{:>9}\n", "case", "energy", "momentum", "angular",
                      "rest a", "rest b", "overl. a", "overl. b", "1 cm at");
  for (const Comparison* row : rows) text += key_row(*row);
  return text + wrapped(in_one_sentence(*pair, rows), 0) + "\n";
}

std::string in_words(const EngineSummary& one) {
  std::string line = one.engine + ":";
  for (const auto& [verdict, count] : one.verdicts) line += fmt::format(" {} {},", count, name_of(verdict));
  line.pop_back();
  if (one.checks > 0) {
    line +=
        fmt::format("; of {} checks {} within 1 % of scale, {} within 0.01 %; {} not a test", one.checks,
                    share_of(one.within[1], one.checks), share_of(one.within[3], one.checks), one.checks - one.evident);
  }
  return wrapped(line, 0);
}

// "impulse, images alike within 0.01 % of scale: shift 100 % of 12, 1 broken; mirror 91 % of 12"
std::string relations_text(const Report& report) {
  std::vector<std::pair<std::string, std::string>> lines;  // by engine
  for (const RelationSummary& one : relation_summaries(report)) {
    const bool first = lines.empty() || lines.back().first != one.engine;
    if (first) lines.emplace_back(one.engine, one.engine + ", images alike within 0.01 % of scale: ");
    lines.back().second +=
        fmt::format("{}{} {} of {}", first ? "" : "; ", one.relation, share_of(one.alike, one.cases), one.cases);
    if (one.broken > 0) lines.back().second += fmt::format(", {} broken", one.broken);
  }
  std::string text;
  for (const auto& [engine, line] : lines) text += wrapped(line, 0);
  return text;
}

}  // namespace

std::string console_text(const Report& report, bool colour) {
  std::string text;
  const RunRecord* before = nullptr;
  for (const RunRecord& run : report.runs) {
    if (before == nullptr || before->scenario != run.scenario) {
      const auto note = std::find_if(report.scenarios.begin(), report.scenarios.end(),
                                     [&](const ScenarioNote& one) { return one.name == run.scenario; });
      text += wrapped(run.scenario + (note == report.scenarios.end() ? "" : ": " + note->question), 0);
    }
    if (before == nullptr || before->scenario != run.scenario || before->variant != run.variant) {
      text += case_text(report, run, colour) + "\n";
    }
    before = &run;
  }
  text += key_table(report);
  for (const EngineSummary& one : engine_summaries(report)) text += in_words(one);
  return text + relations_text(report);
}

}  // namespace plumb
