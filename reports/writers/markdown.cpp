#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reports/system/files.h"
#include "reports/writers/output.h"
#include "reports/writers/summary.h"
#include "scenarios/catalog.h"

namespace plumb::writers::markdown {
namespace {

constexpr std::array verdicts{Verdict::right,       Verdict::coarse,         Verdict::wrong,         Verdict::plausible,
                              Verdict::no_evidence, Verdict::beyond_horizon, Verdict::not_supported, Verdict::failed};

std::string verdict_table(const std::vector<EngineSummary>& engines) {
  std::vector<Verdict> found;
  for (const Verdict one : verdicts) {
    const auto has = [&](const EngineSummary& engine) { return engine.verdicts.count(one) != 0; };
    if (std::any_of(engines.begin(), engines.end(), has)) found.push_back(one);
  }
  std::vector<std::vector<std::string>> rows{{"engine"}};
  for (const Verdict one : found) rows[0].emplace_back(name_of(one));
  for (const EngineSummary& engine : engines) {
    rows.push_back({engine.engine});
    for (const Verdict one : found) {
      const auto count = engine.verdicts.find(one);
      rows.back().push_back(std::to_string(count == engine.verdicts.end() ? 0 : count->second));
    }
  }
  return markdown_table(rows, Cells::numbers);
}

std::string grade_table(const std::vector<EngineSummary>& engines) {
  std::vector<std::vector<std::string>> rows{{"engine", "checks"}};
  for (const double grade : grades) rows[0].push_back(fmt::format("within {:g} %", 100 * grade));
  rows[0].emplace_back("not a test");
  rows[0].emplace_back("laws");
  rows[0].emplace_back("not a test");
  for (const EngineSummary& engine : engines) {
    rows.push_back({engine.engine, std::to_string(engine.checks)});
    for (const int within : engine.within) rows.back().push_back(share_of(within, engine.checks));
    for (const int count : {engine.untested, engine.laws, engine.untested_laws})
      rows.back().push_back(std::to_string(count));
  }
  return markdown_table(rows, Cells::numbers);
}

// Empty if relations were not checked.
std::string relation_table(const Report& report, const std::vector<EngineSummary>& engines) {
  const std::vector<RelationSummary> all = relation_summaries(report);
  std::vector<std::string> names;
  for (const RelationSummary& one : all) {
    if (std::find(names.begin(), names.end(), one.relation) == names.end()) names.push_back(one.relation);
  }
  if (names.empty()) return "";
  std::sort(names.begin(), names.end());
  std::vector<std::vector<std::string>> rows{{"engine"}};
  rows[0].insert(rows[0].end(), names.begin(), names.end());
  for (const EngineSummary& engine : engines) {
    rows.push_back({engine.engine});
    for (const std::string& name : names) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const RelationSummary& one) {
        return one.engine == engine.engine && one.relation == name;
      });
      rows.back().push_back(
          found == all.end()
              ? "-"
              : fmt::format("{} of {}, {} broken", share_of(found->alike, found->cases), found->cases, found->broken));
    }
  }
  return "\n## Which relations hold\n\nThe share of the cases in which a scene and its image move alike within 0.01 % "
         "of "
         "scale, and in how many they differ by more than round-off, the method or its thresholds explain.\n\n" +
         markdown_table(rows, Cells::numbers);
}

// By engine and case, with the tolerances in percent of scale.
std::string lists_of_not_tests(const Report& report, const std::vector<EngineSummary>& engines) {
  std::string text;
  for (const EngineSummary& engine : engines) {
    std::vector<std::vector<std::string>> rows{{"case", "tolerance, % of scale"}};
    for (const RunRecord& run : report.runs) {
      if (run.exact || label_of(run.engine, run.method) != engine.engine) continue;
      std::string all;
      for (const NotATest& one : not_tests(run))
        all += fmt::format("{}{}: {}", all.empty() ? "" : ", ", one.what, percent(one.share));
      if (!all.empty()) rows.push_back({run.scenario + (run.variant.empty() ? "" : ":" + run.variant), all});
    }
    if (rows.size() > 1)
      text +=
          fmt::format("\n## Not a test for {}\n\n{}", markdown_cell(engine.engine), markdown_table(rows, Cells::words));
  }
  return text;
}

std::string of(const RelativeDifference& difference) {
  return fmt::format("{} ({})", percent(difference.largest), percent(difference.end));
}

std::string key_table(const Pair& pair, const std::vector<const Comparison*>& comparisons) {
  std::vector<std::vector<std::string>> rows{{"case", "energy, %", "momentum, %", "angular momentum, %",
                                              "at rest: " + pair.a + ", s", pair.b + ", s",
                                              "overlap: " + pair.a + ", m", pair.b + ", m", "1 cm apart, s"}};
  for (const Comparison* one : comparisons) {
    rows.push_back({one->scenario + (one->variant.empty() ? "" : ":" + one->variant)});
    if (!one->key) {
      rows.back().push_back(one->reason);
      rows.back().resize(rows[0].size());
      continue;
    }
    const KeyDifferences& key = *one->key;
    for (const RelativeDifference& difference : {key.energy, key.momentum, key.angular_momentum}) {
      rows.back().push_back(of(difference));
    }
    for (const auto& value : {key.rest_a, key.rest_b, key.overlap_a, key.overlap_b, key.diverged_at}) {
      rows.back().push_back(short_number(value));
    }
  }
  return markdown_table(rows, Cells::numbers);
}

std::string text_of(const Report& report) {
  const std::vector<EngineSummary> engines = engine_summaries(report);
  std::string text = "# " + markdown_cell(report.title) + "\n";
  if (const auto pair = first_pair(report)) {
    const auto rows = comparisons_of(report, *pair);
    text += fmt::format("\n## {} against {}\n\n{}\n\n", markdown_cell(pair->a), markdown_cell(pair->b),
                        markdown_cell(in_one_sentence(*pair, rows)));
    text +=
        "Differences are the largest over the run (in brackets: at its end), in percent of the scene's own scale. A "
        "body "
        "is at rest below 0.01 m/s and 0.01 rad/s; a dash means never. Overlap is the deepest of the run.\n\n";
    text += key_table(*pair, rows);
  }
  text +=
      "\n## How far from the truth\n\nThe shares of the checks whose error is within so much of the scene's own scale: "
      "the same ruler for every engine. A check is not a test if its tolerance is more than 5 % of its scale, nor is a "
      "law; its scale is what an engine without it would have shown.\n\n";
  text += grade_table(engines);
  text += "\n## Whether the method explains it\n\nCases by verdict.\n\n";
  return text + verdict_table(engines) + relation_table(report, engines) + lists_of_not_tests(report, engines);
}

const Catalog<Writer>::Entry entry{
    {.name = "markdown",
     .file = "report.md",
     .text = [](const Report& report, std::string&) -> std::optional<std::string> { return text_of(report); }}};

}  // namespace
}  // namespace plumb::writers::markdown
