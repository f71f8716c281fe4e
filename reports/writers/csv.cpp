#include <fmt/format.h>

#include "reports/system/files.h"
#include "reports/writers/output.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

std::string beginning(const RunRecord& run) {
  return fmt::format("{},{},{},{},{},{},{}", csv_field(run.scenario), csv_field(run.variant), csv_field(run.engine),
                     csv_field(run.method), csv_field(run.dt), name_of(run.status), name_of(run.verdict));
}

std::string table(const Report& report) {
  std::string text =
      "scenario,variant,engine,method,dt,status,verdict,kind,name,body,time,value,unit,expected,error,tolerance,scale,"
      "passed\n";
  for (const RunRecord& run : report.runs) {
    const std::string begin = beginning(run);
    if (run.metrics.empty() && run.truth.empty()) text += begin + ",run,,,,,,,,,,\n";
    for (const auto& [name, measured] : run.metrics) {
      text += fmt::format("{},metric,{},,,{},{},,,,,\n", begin, csv_field(name), csv_field(measured.value),
                          csv_field(measured.unit));
    }
    for (const TruthCheck& check : run.truth) {
      text += fmt::format("{},truth,{},{},{},{},{},{},{},{},{},{}\n", begin, csv_field(check.quantity),
                          csv_field(check.body), csv_field(check.time), csv_field(check.measured),
                          csv_field(check.unit), csv_field(check.expected), csv_field(check.error),
                          csv_field(check.tolerance), csv_field(check.scale),
                          !check.reported ? "not reported"
                          : check.passed  ? "yes"
                                          : "no");
    }
    for (const InvariantCheck& check : run.invariants) {
      const bool shown = is_judged(check);
      text +=
          fmt::format("{},invariant,{},{},{},{},{},,,{},{},{}\n", begin, csv_field(check.name), csv_field(check.where),
                      csv_field(check.time), shown ? csv_field(check.value) : "", csv_field(check.unit),
                      shown ? csv_field(check.tolerance) : "", shown ? csv_field(check.scale) : "",
                      check.status == CheckStatus::held     ? "yes"
                      : check.status == CheckStatus::broken ? "no"
                                                            : name_of(check.status));
    }
  }
  return text;
}

const Catalog<Writer>::Entry csv_entry{
    {.name = "csv", .file = "report.csv", .text = [](const Report& report, std::string&) -> std::optional<std::string> {
       return table(report);
     }}};

}  // namespace
}  // namespace plumb
