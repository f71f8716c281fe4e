#include "reports/prove/sensitivity_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace plumb {
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
