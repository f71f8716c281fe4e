#include <fmt/format.h>

#include <cmath>

#include "reports/writer.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

// RFC 4180: what holds a comma, a quote or a line break is quoted, quotes doubled.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter;
    if (letter == '"') quoted += '"';
  }
  return quoted + '"';
}

// The shortest that reads back to the same bits; empty where there is no number.
std::string field(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

std::string beginning(const RunRecord& run) {
  return fmt::format("{},{},{},{},{},{},{}", field(run.scenario), field(run.variant), field(run.engine),
                     field(run.method), field(run.dt), name_of(run.status), name_of(run.verdict));
}

std::string table(const Report& report) {
  std::string text =
      "scenario,variant,engine,method,dt,status,verdict,kind,name,body,time,value,unit,expected,error,tolerance,"
      "passed\n";
  for (const RunRecord& run : report.runs) {
    const std::string begin = beginning(run);
    if (run.metrics.empty() && run.truth.empty()) text += begin + ",run,,,,,,,,,\n";
    for (const auto& [name, measured] : run.metrics) {
      text +=
          fmt::format("{},metric,{},,,{},{},,,,\n", begin, field(name), field(measured.value), field(measured.unit));
    }
    for (const TruthCheck& check : run.truth) {
      text += fmt::format("{},truth,{},{},{},{},{},{},{},{},{}\n", begin, field(check.quantity), field(check.body),
                          field(check.time), field(check.measured), field(check.unit), field(check.expected),
                          field(check.error), field(check.tolerance),
                          !check.revealed ? "not revealed"
                          : check.passed  ? "yes"
                                          : "no");
    }
    for (const InvariantCheck& check : run.invariants) {
      const bool shown = check.standing != Standing::not_revealed;
      text += fmt::format("{},invariant,{},{},{},{},{},,,{},{}\n", begin, field(check.name), field(check.where),
                          field(check.time), shown ? field(check.value) : "", field(check.unit),
                          shown ? field(check.allowed) : "",
                          check.standing == Standing::held     ? "yes"
                          : check.standing == Standing::broken ? "no"
                                                               : name_of(check.standing));
    }
  }
  return text;
}

const Catalog<Writer>::Entry entry{
    {.name = "csv", .file = "report.csv", .text = [](const Report& report, std::string&) -> std::optional<std::string> {
       return table(report);
     }}};

}  // namespace
}  // namespace plumb
