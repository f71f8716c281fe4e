#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/prove/controls.h"
#include "reports/prove/report.h"

namespace plumb {
namespace {

std::string case_label(const ControlRun& run) { return run.scenario + (run.variant.empty() ? "" : " " + run.variant); }

std::string share_text(double share) {
  return std::isfinite(share) ? fmt::format("{:.3g} % of the scale", 100 * share) : "not comparable";
}

std::string line_of(const ControlResult& result) {
  std::string line =
      fmt::format("{:<18}{:>7}{:>11}{:>6}{:>14}{:>8}   ", result.control.name, result.count(Unmasking::truth),
                  result.count(Unmasking::invariant), result.count(Unmasking::same),
                  result.count(Unmasking::inconclusive), result.count(Unmasking::passes));
  if (const ControlRun* best = result.best()) {
    line += fmt::format("{}: {}, {}", case_label(*best), best->detection->metric, ratio_text(best->detection->ratio));
  }
  return line + "\n";
}

std::string lines_by_case(const ControlResult& result) {
  std::string text = fmt::format("\n{}: {}\n", result.control.name, result.control.about);
  for (const ControlRun& run : result.runs) {
    text += fmt::format("  {:<28}{:<14}{:<14}", case_label(run), name_of(run.unmasking), name_of(run.verdict));
    text += run.detection ? fmt::format("{}, {}\n", run.detection->metric, ratio_text(run.detection->ratio))
                          : fmt::format("differs by {}\n", share_text(run.difference));
  }
  return text;
}

nlohmann::ordered_json json_of(const ControlRun& run) {
  nlohmann::ordered_json json{{"scenario", run.scenario},
                              {"variant", run.variant},
                              {"outcome", name_of(run.unmasking)},
                              {"verdict", name_of(run.verdict)},
                              {"difference", number_or_null(run.difference)}};
  if (run.detection) json["detection"] = to_json(*run.detection);
  return json;
}

}  // namespace

std::string text_of(const ControlReport& report, bool each_case) {
  std::string text = fmt::format(
      "controls: {}, judged by what {} states; false passes: {}; cases: {}, of which {} are left out: our engine is "
      "wrong in them.\n\n",
      report.results.size(), report.stated, report.passes(), report.cases, report.left_out);
  text += fmt::format("{:<18}{:>7}{:>11}{:>6}{:>14}{:>8}   {}\n", "control", "truth", "invariant", "same",
                      "inconclusive", "PASSES", "unmasked best in");
  for (const ControlResult& result : report.results) text += line_of(result);
  if (report.passes() > 0) text += "\n";
  for (const ControlResult& result : report.results) {
    for (const ControlRun& run : result.runs) {
      if (run.unmasking != Unmasking::passes) continue;
      text += fmt::format("FALSE PASS of {}: {} is {}; differs by {}\n", result.control.name, case_label(run),
                          name_of(run.verdict), share_text(run.difference));
    }
  }
  if (each_case) {
    for (const ControlResult& result : report.results) text += lines_by_case(result);
  }
  return text;
}

nlohmann::ordered_json to_json(const std::vector<ControlReport>& reports) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ControlReport& report : reports) {
    nlohmann::ordered_json controls = nlohmann::ordered_json::array();
    for (const ControlResult& result : report.results) {
      nlohmann::ordered_json runs = nlohmann::ordered_json::array();
      for (const ControlRun& run : result.runs) runs.push_back(json_of(run));
      controls.push_back({{"name", result.control.name},
                          {"about", result.control.about},
                          {"false_passes", result.count(Unmasking::passes)},
                          {"runs", runs}});
    }
    all.push_back({{"stated_by", report.stated},
                   {"cases", report.cases},
                   {"left_out", report.left_out},
                   {"false_passes", report.passes()},
                   {"controls", controls}});
  }
  return {{"statements", all}};
}

}  // namespace plumb
