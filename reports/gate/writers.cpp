#include "reports/gate/writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/gate/baseline.h"
#include "reports/gate/result.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

const Catalog<GateWriter>::Entry text_entry{
    {.name = "text", .about = "every regression, one per line", .text = [](const GateResult& result) {
       return text_of(result, result.regressions.size());
     }}};

constexpr std::size_t most_rows = 100;  // a comment on a pull request holds 65536 characters

std::string markdown(const GateResult& result) {
  std::string text = fmt::format("### Plumb: {}\n", markdown_cell(result.verdict));
  if (!result.passed()) {
    text += "\n| | run | what | before | now | allowed | why |\n|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < result.regressions.size() && i < most_rows; ++i) {
      const Regression& one = result.regressions[i];
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", name_of(one.change), markdown_cell(one.run.text()),
                          markdown_cell(one.metric), markdown_cell(one.before), markdown_cell(one.now),
                          markdown_cell(one.tolerance), markdown_cell(one.why));
    }
    if (result.regressions.size() > most_rows) {
      text += fmt::format("\nAnd {} more.\n", result.regressions.size() - most_rows);
    }
    text += "\nIf these changes are intended, `plumb accept` makes them the baseline.\n";
  }
  for (const std::string& note : result.notes) text += "\n" + markdown_cell(note) + "\n";
  return text;
}

const Catalog<GateWriter>::Entry markdown_entry{
    {.name = "markdown", .about = "a summary for a pull request", .text = markdown}};

std::string test_case(const GateResult& result, const RunKey& run) {
  const std::string name = label_of(run.engine, run.method);
  const std::string about = run.scenario + (run.variant.empty() ? "" : " " + run.variant);
  std::string text =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", xml_escaped(about), xml_escaped(name));
  std::string lines;
  const Regression* worst = nullptr;
  for (const Regression& one : result.regressions) {
    if (one.run != run) continue;
    if (worst == nullptr) worst = &one;
    lines += xml_escaped(in_words(one)) + "\n";
  }
  if (worst == nullptr) return text + "/>\n";
  return text + fmt::format(">\n      <failure type=\"{}\" message=\"{}\">{}</failure>\n    </testcase>\n",
                            name_of(worst->change), xml_escaped(worst->metric + ": " + worst->why), lines);
}

// The dialect that CI systems read, described at https://github.com/testmoapp/junitxml.
std::string junit(const GateResult& result) {
  std::set<RunKey> failed;
  for (const Regression& one : result.regressions) failed.insert(one.run);
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"0\"",
                                         result.runs.size(), failed.size());
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"plumb check\" {}>\n  <testsuite name=\"plumb check\" {}>\n", counts, counts);
  for (const RunKey& run : result.runs) text += test_case(result, run);
  text += fmt::format("    <system-out>{}\n", xml_escaped(result.verdict));
  for (const std::string& note : result.notes) text += xml_escaped(note) + "\n";
  return text + "</system-out>\n  </testsuite>\n</testsuites>\n";
}

const Catalog<GateWriter>::Entry junit_entry{
    {.name = "junit", .about = "JUnit XML, one test case for each run", .text = junit}};

constexpr int page_document_format = 2;

Json json_of(const Regression& one) {
  return {{"scenario", one.run.scenario},
          {"variant", one.run.variant},
          {"engine", one.run.engine},
          {"method", one.run.method},
          {"metric", one.metric},
          {"before", one.before},
          {"now", one.now},
          {"tolerance", one.tolerance},
          {"why", one.why},
          {"change", name_of(one.change)}};
}

Json findings_of(const GateResult& result) {
  Json regressions = Json::array();
  for (const Regression& one : result.regressions) regressions.push_back(json_of(one));
  return {{"verdict", result.verdict},
          {"notes", result.notes},
          {"runs", result.runs.size()},
          {"regressions", std::move(regressions)}};
}

const Catalog<GateWriter>::Entry json_entry{
    {.name = "json", .about = "verdict, notes and every regression as JSON", .text = [](const GateResult& result) {
       return findings_of(result).dump(1) + "\n";
     }}};

template <class Map>
void keep_shared(Map& a, Map& b) {
  std::erase_if(a, [&](const auto& entry) { return b.count(entry.first) == 0; });
  std::erase_if(b, [&](const auto& entry) { return a.count(entry.first) == 0; });
}

}  // namespace

std::string in_words(const Regression& one) {
  std::string text = fmt::format("{}: {}: {}", name_of(one.change), one.run.text(), one.metric);
  if (!one.before.empty()) text += ": " + one.before;
  if (!one.now.empty()) text += (one.before.empty() ? ": now " : ", now ") + one.now;
  if (!one.tolerance.empty()) text += ", allowed " + one.tolerance;
  return printable(text + "; " + one.why, text.npos);
}

std::string text_of(const GateResult& result, std::size_t most) {
  std::string text = result.verdict + "\n";
  for (std::size_t i = 0; i < result.regressions.size() && i < most; ++i)
    text += "  " + in_words(result.regressions[i]) + "\n";
  if (result.regressions.size() > most) text += fmt::format("  and {} more\n", result.regressions.size() - most);
  for (const std::string& note : result.notes) text += printable(note, note.npos) + "\n";
  return text;
}

std::optional<Json> changes_since(const std::string& file, const Report& report) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  Baseline before = read_baseline(file), now = baseline_of(report);
  if (before.dt != now.dt) return std::nullopt;
  keep_shared(before.runs, now.runs);
  keep_shared(before.engines, now.engines);  // an engine that only one of them has is not a changed engine
  const GateResult result = compare(before, now);
  return Json{{"plumb", page_document_format},
              {"study", "baseline"},
              {"about", "Compared with the accepted baseline"},
              {"configuration", {{"baseline", std::filesystem::path(file).filename().string()}}},
              {"environment", report.environment},
              {"results", Json::array()},
              {"findings", findings_of(result)},
              {"timings", {{"results", Json::object()}}}};
}

}  // namespace plumb
