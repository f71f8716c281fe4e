#include "reports/gate/baseline.h"

#include <fmt/format.h>

#include <cstdint>

#include "reports/run/horizon.h"

namespace plumb {
namespace {

// Without the time of an event, which differs between runs.
std::string name_of_check(const TruthCheck& check) {
  const bool is_event = check.quantity == name_of(Quantity::apex) || check.quantity == name_of(Quantity::landing);
  return fmt::format("truth: {}{}{}", check.quantity, check.body.empty() ? "" : " of " + check.body,
                     is_event ? "" : fmt::format(" at {:.6g} s", check.time));
}

// The second number of the same name is called "... (2)".
void add_number(std::map<std::string, BaselineNumber>& numbers, const std::string& name, BaselineNumber number) {
  std::string unique = name;
  for (int i = 2; numbers.count(unique) != 0; ++i) unique = fmt::format("{} ({})", name, i);
  numbers.emplace(std::move(unique), std::move(number));
}

CheckStatus status_of(const TruthCheck& check) {
  if (!check.reported) return CheckStatus::not_reported;
  return check.passed ? CheckStatus::held : CheckStatus::broken;
}

}  // namespace

std::string RunKey::text() const {
  return fmt::format("{}{}, {}", scenario, variant.empty() ? "" : " " + variant, label_of(engine, method));
}

RunKey key_of(const RunRecord& run) { return {run.scenario, run.variant, run.engine, run.method}; }

std::map<std::string, std::string> platform_of(const std::map<std::string, std::string>& environment) {
  std::map<std::string, std::string> platform;
  for (const char* name : {"architecture", "compiler", "flags", "libm"}) {
    const auto found = environment.find(name);
    if (found != environment.end()) platform.insert(*found);
  }
  return platform;
}

BaselineRun baseline_run_of(const RunRecord& run) {
  BaselineRun all{.exact = run.exact,
                  .verdict = run.verdict,
                  .reason = run.status == Status::ok ? "" : run.reason,
                  .bits = run.trace ? fmt::format("{:016x}", hash_of(*run.trace)) : ""};
  for (const auto& [name, measured] : run.metrics) {
    // The horizon needs an ensemble of runs, which `plumb check` does not make.
    if (name == horizon_note().name) continue;
    BaselineNumber number{measured.unit, measured.value};
    if (run.converged && name.starts_with("truth_")) number.bound = unbounded;
    add_number(all.numbers, name, number);
  }
  for (const TruthCheck& check : run.truth) {
    BaselineNumber number{check.unit, check.error, status_of(check), check.tolerance};
    if (check.converged) number.bound = unbounded;
    add_number(all.numbers, name_of_check(check), number);
  }
  for (const InvariantCheck& check : run.invariants) {
    add_number(all.numbers, "invariant: " + check.name, {check.unit, check.value, check.status, check.tolerance});
  }
  return all;
}

Baseline baseline_of(const Report& report) {
  Baseline baseline{.platform = platform_of(report.environment)};
  for (const EngineNote& engine : report.engines) {
    if (!engine.exact) baseline.engines[engine.name] = engine.source;
    if (!engine.word.empty()) baseline.words[engine.name] = engine.word;
  }
  for (const RunRecord& run : report.runs) {
    baseline.dt = run.dt;
    if (run.exact && run.converged) continue;
    baseline.runs.emplace(key_of(run), baseline_run_of(run));
  }
  return baseline;
}

}  // namespace plumb
