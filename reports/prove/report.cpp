#include "reports/prove/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string method_of(const Fault& fault) {
  std::string text;
  for (const auto& [option, value] : fault.method) text += (text.empty() ? "" : ",") + value;
  return text.empty() ? "accurate" : text;
}

std::string case_of(const Detection& one) { return one.scenario + (one.variant.empty() ? "" : " " + one.variant); }

std::string line_of(const FaultResult& result) {
  const Detection* best = result.best();
  if (best == nullptr) {
    return fmt::format("{:<30}{:<26}{}\n", result.fault.name, method_of(result.fault),
                       result.detections.empty() ? "NOT SEEN: the same bits everywhere" : "NOT SEEN: only bits differ");
  }
  return fmt::format("{:<30}{:<26}{:<28}{:<20.20}{:<10}{:>18}{:>10}\n", result.fault.name, method_of(result.fault),
                     case_of(*best), best->metric, name_of(best->kind), ratio_text(best->ratio),
                     result.scenarios().size());
}

Json json_of(const std::vector<Detection>& all) {
  Json list = Json::array();
  for (const Detection& one : all) list.push_back(to_json(one));
  return list;
}

// Several phases or bodies of a run may fail the same check.
struct Alarm {
  const Detection* worst = nullptr;
  const CleanRun* worst_run = nullptr;
  std::set<const CleanRun*> runs;
};

std::string false_alarms_text(const ProveReport& report) {
  std::map<std::pair<std::string, std::string>, Alarm> alarms;  // by case and check
  for (const CleanRun& run : report.clean) {
    for (const Detection& one : run.false_alarms) {
      Alarm& alarm = alarms[{case_of(one), one.metric}];
      alarm.runs.insert(&run);
      if (alarm.worst != nullptr && one.ratio <= alarm.worst->ratio) continue;
      alarm.worst = &one;
      alarm.worst_run = &run;
    }
  }
  std::string text;
  for (const auto& [check, alarm] : alarms) {
    const Detection& worst = *alarm.worst;
    text += fmt::format("FALSE ALARM in {}, {}: {:.3g}{} where {:.3g} is allowed ({}), with {}", check.first,
                        check.second, worst.error, worst.unit.empty() ? "" : " " + worst.unit, worst.tolerance,
                        ratio_text(worst.ratio), alarm.worst_run->settings);
    text += alarm.runs.size() > 1 ? fmt::format("; in {} clean runs\n", alarm.runs.size()) : "\n";
  }
  return text;
}

std::string loose_truths_text(const ProveReport& report) {
  std::string text;
  for (const CleanRun& run : report.clean) {
    for (const LooseTruth& one : run.loose) {
      text += fmt::format("NOT A TEST in {} {}, {}: {:.2g} of its scale is allowed, more than {:g} %\n", one.scenario,
                          one.variant, one.check.what, one.check.share, 100 * evidence_share);
    }
  }
  return text;
}

}  // namespace

std::size_t ProveReport::caught() const {
  return static_cast<std::size_t>(
      std::count_if(faults.begin(), faults.end(), [](const FaultResult& result) { return result.caught(); }));
}

std::size_t ProveReport::caught_by_physics() const {
  return static_cast<std::size_t>(std::count_if(faults.begin(), faults.end(),
                                                [](const FaultResult& result) { return result.caught_by_physics(); }));
}

std::size_t ProveReport::runs_with_false_alarms() const {
  return static_cast<std::size_t>(
      std::count_if(clean.begin(), clean.end(), [](const CleanRun& run) { return !run.false_alarms.empty(); }));
}

std::size_t ProveReport::loose_truths() const {
  return std::accumulate(clean.begin(), clean.end(), std::size_t{0},
                         [](std::size_t sum, const CleanRun& run) { return sum + run.loose.size(); });
}

bool ProveReport::passed() const {
  return caught() == faults.size() && runs_with_false_alarms() == 0 && loose_truths() == 0;
}

std::string text_of(const ProveReport& report) {
  std::string text = fmt::format(
      "{} of {} faults caught, {} of them by truth or invariant; false alarms in {} of {} clean runs; cases: {}.\n\n",
      report.caught(), report.faults.size(), report.caught_by_physics(), report.runs_with_false_alarms(),
      report.clean.size(), report.cases);
  text += fmt::format("{:<30}{:<26}{:<28}{:<20}{:<10}{:>18}{:>10}\n", "fault", "method", "caught in", "metric", "by",
                      "error", "scenarios");
  for (const FaultResult& result : report.faults) text += line_of(result);
  text += fmt::format("\nThe fewest scenarios that catch them all: {}.\n",
                      fmt::join(fewest_scenarios(report.faults), ", "));
  return text + false_alarms_text(report) + loose_truths_text(report);
}

Json to_json(const ProveReport& report) {
  Json faults = Json::array();
  for (const FaultResult& result : report.faults) {
    faults.push_back({{"name", result.fault.name},
                      {"about", result.fault.about},
                      {"source", result.fault.source},
                      {"method", method_of(result.fault)},
                      {"caught", result.caught()},
                      {"detections", json_of(result.detections)}});
  }
  Json clean = Json::array();
  Json loose = Json::array();
  for (const CleanRun& run : report.clean) {
    clean.push_back({{"seed", run.seed}, {"settings", run.settings}, {"false_alarms", json_of(run.false_alarms)}});
    for (const LooseTruth& one : run.loose) {
      loose.push_back({{"scenario", one.scenario},
                       {"variant", one.variant},
                       {"what", one.check.what},
                       {"share", number_or_null(one.check.share)}});
    }
  }
  return {{"caught", report.caught()}, {"false_alarms", report.runs_with_false_alarms()},
          {"cases", report.cases},     {"fewest_scenarios", fewest_scenarios(report.faults)},
          {"faults", faults},          {"clean", clean},
          {"not_a_test", loose}};
}

std::string ratio_text(double ratio) {
  if (!std::isfinite(ratio)) return "unbounded";
  return ratio < 1e6 ? fmt::format("{:.3g} x allowed", ratio) : fmt::format("{:.1e} x allowed", ratio);
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Detection& one) {
  return {{"scenario", one.scenario},   {"variant", one.variant},
          {"kind", name_of(one.kind)},  {"metric", one.metric},
          {"unit", one.unit},           {"error", number_or_null(one.error)},
          {"tolerance", one.tolerance}, {"ratio", number_or_null(one.ratio)}};
}

namespace {

using SensitivityJson = nlohmann::ordered_json;

// "0.12 %", "3.4e-07", "2e-05 1/s", "over 10 %".
std::string error_text(const Perturbation& parameter, const std::optional<Sighting>& seen) {
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  const auto text = [&](double error) -> std::string {
    if (error <= smallest_error) return fmt::format("under {:.0e}{}", smallest_error, unit);
    if (!unit.empty()) return fmt::format("{:.2g}{}", error, unit);
    return error < 1e-4 ? fmt::format("{:.1e}", error) : fmt::format("{:.2g} %", 100 * error);
  };
  return seen ? text(std::abs(seen->error)) : "over " + text(largest_error);
}

std::string case_text(const Detection& one) { return one.scenario + (one.variant.empty() ? "" : ":" + one.variant); }

std::size_t missed(const SensitivityReport& report, std::size_t statement) {
  return static_cast<std::size_t>(
      std::count_if(report.found.parameters.begin(), report.found.parameters.end(),
                    [&](const Sensitivity& one) { return !one.reaches(statement, report.statements[statement]); }));
}

}  // namespace

bool SensitivityReport::passed() const {
  for (std::size_t s = 0; s < statements.size(); ++s) {
    if (missed(*this, s) > 0) return false;
  }
  return true;
}

std::string text_of(const SensitivityReport& report) {
  std::string text = fmt::format(
      "The smallest error put into our engine that a case calls wrong, by what each engine states about itself; "
      "cases: {}.\n\n{:<20}{:<10}{:<18}{:<34}{:<28}{:<10}\n",
      report.cases, "parameter", "by", "error seen", "in", "check", "kind");
  for (const Sensitivity& one : report.found.parameters) {
    for (std::size_t s = 0; s < report.statements.size(); ++s) {
      const std::optional<Sighting>& seen = one.sighted[s];
      text += fmt::format("{:<20}{:<10}{:<18}{:<33} {:<27} {:<10}{}\n", s == 0 ? one.parameter.name : "",
                          report.statements[s].engine, error_text(one.parameter, seen),
                          seen ? case_text(seen->detection) : fmt::format("none of {} cases", one.cases),
                          seen ? seen->detection.metric : "", seen ? name_of(seen->detection.kind) : "",
                          one.reaches(s, report.statements[s]) ? "" : "MISSES ITS GOAL");
    }
  }
  text += "\n";
  for (const std::string& one : report.found.unstable) {
    text += fmt::format("an error of round-off size, {:.0e}, breaks {}\n", round_off_error, one);
  }
  for (std::size_t s = 0; s < report.statements.size(); ++s) {
    const EngineStatement& statement = report.statements[s];
    if (!statement.goal) continue;
    text += fmt::format("{}: {} of {} parameters within the goal of {:.2g}\n", statement.engine,
                        report.found.parameters.size() - missed(report, s), report.found.parameters.size(),
                        *statement.goal);
  }
  return text;
}

std::string markdown_of(const SensitivityReport& report) {
  std::string header = "| error in |";
  std::string rule = "|---|";
  for (const EngineStatement& statement : report.statements) {
    header += fmt::format(" by {} | seen in |", statement.engine);
    rule += "--:|---|";
  }
  std::string text = header + "\n" + rule + "\n";
  for (const Sensitivity& one : report.found.parameters) {
    text += fmt::format("| {} |", one.parameter.name);
    for (const std::optional<Sighting>& seen : one.sighted) {
      text += fmt::format(" {} | {} |", error_text(one.parameter, seen),
                          seen ? fmt::format("{}, {}", case_text(seen->detection), seen->detection.metric) : "-");
    }
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json to_json(const SensitivityReport& report) {
  SensitivityJson parameters = SensitivityJson::array();
  for (const Sensitivity& one : report.found.parameters) {
    SensitivityJson seen = SensitivityJson::array();
    for (std::size_t s = 0; s < report.statements.size(); ++s) {
      SensitivityJson by{{"statement", report.statements[s].engine}};
      by["reaches_goal"] = one.reaches(s, report.statements[s]);
      if (const std::optional<Sighting>& sighting = one.sighted[s]) {
        by["error"] = sighting->error;
        by["scenario"] = sighting->detection.scenario;
        by["variant"] = sighting->detection.variant;
        by["kind"] = name_of(sighting->detection.kind);
        by["check"] = sighting->detection.metric;
      } else {
        by["error"] = nullptr;
      }
      seen.push_back(std::move(by));
    }
    parameters.push_back({{"name", one.parameter.name},
                          {"about", one.parameter.about},
                          {"unit", one.parameter.unit},
                          {"cases", one.cases},
                          {"seen", std::move(seen)}});
  }
  SensitivityJson statements = SensitivityJson::array();
  for (const EngineStatement& one : report.statements) {
    statements.push_back(
        {{"engine", one.engine}, {"goal", one.goal ? SensitivityJson(*one.goal) : SensitivityJson(nullptr)}});
  }
  return {{"dt", report.dt},
          {"cases", report.cases},
          {"largest_error", largest_error},
          {"statements", std::move(statements)},
          {"unstable", report.found.unstable},
          {"parameters", std::move(parameters)}};
}

}  // namespace plumb
