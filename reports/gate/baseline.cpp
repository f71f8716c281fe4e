#include "reports/gate/baseline.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "reports/run/horizon.h"
#include "reports/run/report_json.h"
#include "reports/system/files.h"
#include "scenarios/scene/json_reader.h"

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

namespace {

using Json = nlohmann::ordered_json;

constexpr int baseline_format = 4;  // grows when a reader of the previous version would misread the new one
constexpr std::size_t largest_file = std::size_t{64} << 20;
constexpr const char* any = "any";  // stands for `unbounded`

// Two digits, so that a diff does not show changes of bounds that mean nothing.
double rounded(double bound) { return bound == 0 ? 0 : std::stod(fmt::format("{:.1e}", bound)); }

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json json_of(const BaselineNumber& number) {
  Json json{{"value", number.value}, {"unit", number.unit}};
  if (number.status) {
    json["status"] = name_of(*number.status);
    json["tolerance"] = number.tolerance;
  }
  if (number.bound) json["bound"] = *number.bound == unbounded ? Json(any) : Json(rounded(*number.bound));
  if (number.unstable) json["unstable"] = true;
  return json;
}

std::string text_of(const RunKey& key, const BaselineRun& run) {
  Json perturbed_verdicts = Json::array();
  for (const Verdict verdict : run.perturbed_verdicts) perturbed_verdicts.push_back(name_of(verdict));
  const auto line = [](const char* name, const Json& value) {
    return fmt::format("   \"{}\": {},\n", name, dumped(value));
  };
  std::string text = "  {\n";
  text += line("scenario", key.scenario) + line("variant", key.variant);
  text += line("engine", key.engine) + line("method", key.method);
  text += line("exact", run.exact) + line("verdict", name_of(run.verdict)) + line("reason", run.reason);
  text += line("perturbed_verdicts", perturbed_verdicts) + line("bits", run.bits);
  text += "   \"numbers\": {";
  const char* separator = "\n";
  for (const auto& [name, number] : run.numbers) {
    text += fmt::format("{}    {}: {}", separator, dumped(name), dumped(json_of(number)));
    separator = ",\n";
  }
  return text + "\n   }\n  }";
}

// Gives the keys of version 1 the names they have in version 2.
void update_baseline(nlohmann::json& baseline) {
  if (!baseline.contains("runs") || !baseline["runs"].is_array()) return;
  for (nlohmann::json& run : baseline["runs"]) {
    rename_key(run, "neighbours", "perturbed_verdicts");
    if (!run.is_object() || !run.contains("numbers") || !run["numbers"].is_object()) continue;
    for (nlohmann::json& number : run["numbers"]) {
      update_check(number);
      rename_key(number, "moves", "bound");
      rename_key(number, "wavers", "unstable");
    }
  }
}

BaselineNumber number_from(const JsonReader& from) {
  from.object({"value", "unit"}, {"status", "tolerance", "bound", "unstable"});
  BaselineNumber number{.unit = any_text(from["unit"]), .value = number_or_null(from["value"])};
  if (from.has("status")) {
    number.status = check_status_from(from["status"]);
    from.must_have("tolerance");
    number.tolerance = number_or_null(from["tolerance"]);
  }
  if (from.has("bound")) {
    const JsonReader bound = from["bound"];
    number.bound = bound.value() == any ? unbounded : bound.number({0, std::numeric_limits<double>::max()});
  }
  number.unstable = from.boolean("unstable", false);
  return number;
}

void add_run(const JsonReader& from, Baseline& baseline) {
  from.object({"scenario", "variant", "engine", "method", "exact", "verdict", "reason", "perturbed_verdicts", "bits",
               "numbers"});
  const RunKey key{any_text(from["scenario"]), any_text(from["variant"]), any_text(from["engine"]),
                   any_text(from["method"])};
  BaselineRun run{.exact = from["exact"].boolean(),
                  .verdict = verdict_from(from["verdict"]),
                  .reason = any_text(from["reason"]),
                  .bits = any_text(from["bits"])};
  for_each_entry(from["perturbed_verdicts"], {},
                 [&](const JsonReader& verdict) { run.perturbed_verdicts.insert(verdict_from(verdict)); });
  for_each_member(from["numbers"], [&](const std::string& name, const JsonReader& number) {
    run.numbers.emplace(name, number_from(number));
  });
  if (!baseline.runs.emplace(key, std::move(run)).second) from.refuse("the run of " + key.text() + " is there twice");
}

Baseline baseline_from(nlohmann::json json, const std::string& path) {
  const JsonReader from(json, path);
  from.must_have("plumb_baseline");
  const double format = from["plumb_baseline"].number({1, baseline_format});
  if (format < 2) update_baseline(json);
  from.object({"plumb_baseline", "dt", "all", "scenarios", "platform", "engines", "runs"}, {"words"});
  Baseline baseline{.dt = from["dt"].number({std::numeric_limits<double>::min(), 1, "s"}),
                    .all = from["all"].boolean(),
                    .scenarios = text_list_from(from["scenarios"]),
                    .platform = text_map_from(from["platform"]),
                    .engines = text_map_from(from["engines"])};
  if (from.has("words")) baseline.words = text_map_from(from["words"]);
  for_each_entry(from["runs"], {}, [&](const JsonReader& run) { add_run(run, baseline); });
  baseline.old_verdicts = format < 3;
  baseline.old_statuses = format < 4;
  return baseline;
}

nlohmann::json parse_file(const std::string& path) { return parse_json(read_text(path, largest_file), path); }

}  // namespace

std::string to_text(const Baseline& baseline) {
  std::string text = fmt::format("{{\n \"plumb_baseline\": {},\n \"dt\": {},\n \"all\": {},\n \"scenarios\": {},\n",
                                 baseline_format, dumped(baseline.dt), baseline.all, dumped(baseline.scenarios));
  text += fmt::format(" \"platform\": {},\n \"engines\": {},\n", dumped(Json(baseline.platform)),
                      dumped(Json(baseline.engines)));
  if (!baseline.words.empty()) text += fmt::format(" \"words\": {},\n", dumped(Json(baseline.words)));
  text += " \"runs\": [";
  const char* separator = "\n";
  for (const auto& [key, run] : baseline.runs) {
    text += separator + text_of(key, run);
    separator = ",\n";
  }
  return text + "\n ]\n}\n";
}

Baseline read_baseline(const std::string& path) { return baseline_from(parse_file(path), path); }

Baseline read_results(const std::string& path) {
  nlohmann::json json = parse_file(path);
  const JsonReader from(json, path);
  if (!json.is_object()) from.expected("a baseline or a report.json");
  if (json.contains("plumb_baseline")) return baseline_from(std::move(json), path);
  if (!json.contains("plumb") || !json.contains("runs")) {
    from.refuse("this is neither a baseline (plumb accept) nor a report.json (plumb run)");
  }
  Baseline baseline = baseline_of(report_from(std::move(json), path));
  std::set<std::string> cases;
  for (const auto& [key, run] : baseline.runs) cases.insert(key.scenario + ":" + key.variant);
  baseline.scenarios.assign(cases.begin(), cases.end());
  return baseline;
}

}  // namespace plumb
