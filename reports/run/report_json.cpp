#include "reports/run/report_json.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace plumb {
namespace {

template <class T, std::size_t n>
std::array<Word<T>, n> names_of(const std::array<T, n>& values) {
  std::array<Word<T>, n> names{};
  for (std::size_t i = 0; i < n; ++i) names[i] = {name_of(values[i]), values[i]};
  return names;
}

nlohmann::json* find_list(nlohmann::json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_array() ? &*found : nullptr;
}

// Version 1 had other names for some fields of checks; version 2 had no scales, so none of its checks is evidence;
// version 3 did not say how a command line names an engine.
void update_report(nlohmann::json& report, int version) {
  if (nlohmann::json* engines = find_list(report, "engines")) {
    for (nlohmann::json& engine : *engines) {
      if (engine.is_object()) engine.emplace("word", "");
    }
  }
  if (version > 2) return;
  nlohmann::json* runs = find_list(report, "runs");
  if (runs == nullptr) return;
  for (nlohmann::json& run : *runs) {
    if (nlohmann::json* truth = find_list(run, "truth")) {
      for (nlohmann::json& check : *truth) {
        if (version == 1) rename_key(check, "revealed", "reported");
        if (check.is_object()) check.emplace("scale", nullptr);
      }
    }
    nlohmann::json* invariants = find_list(run, "invariants");
    if (version == 1 && invariants != nullptr) {
      for (nlohmann::json& check : *invariants) update_check(check);
    }
  }
}

TruthCheck truth_check_from(const JsonReader& from) {
  return {.body = any_text(from["body"]),
          .quantity = any_text(from["quantity"]),
          .unit = any_text(from["unit"]),
          .time = number_or_null(from["time"]),
          .error = number_or_null(from["error"]),
          .tolerance = number_or_null(from["tolerance"]),
          .scale = number_or_null(from["scale"]),
          .chance = from.number("chance", 0, {0, 1e300}),
          .passed = from["passed"].boolean(),
          .reported = from["reported"].boolean()};
}

InvariantCheck invariant_check_from(const JsonReader& from) {
  const double ratio = number_or_null(from["ratio"]);
  return {.name = any_text(from["name"]),
          .unit = any_text(from["unit"]),
          .status = check_status_from(from["status"]),
          .value = number_or_null(from["value"]),
          .tolerance = number_or_null(from["tolerance"]),
          .ratio = std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity()};
}

RunRecord run_record_from(const JsonReader& from) {
  RunRecord run{.scenario = any_text(from["scenario"]),
                .variant = any_text(from["variant"]),
                .engine = any_text(from["engine"]),
                .method = any_text(from["method"]),
                .exact = from["exact"].boolean(),
                .dt = from["dt"].number({0, 1, "s"}),
                .verdict = verdict_from(from["verdict"])};
  for_each_member(from["metrics"], [&](const std::string& name, const JsonReader& metric) {
    metric.object({"value", "unit"});
    run.metrics[name] = {number_or_null(metric["value"]), any_text(metric["unit"])};
  });
  for_each_entry(from["truth"],
                 {"body", "quantity", "unit", "time", "error", "tolerance", "scale", "passed", "reported"},
                 [&](const JsonReader& check) { run.truth.push_back(truth_check_from(check)); });
  for_each_entry(from["invariants"], {"name", "unit", "status", "value", "tolerance", "ratio"},
                 [&](const JsonReader& check) { run.invariants.push_back(invariant_check_from(check)); });
  return run;
}

Timing timing_from(const JsonReader& from) {
  return {.scenario = any_text(from["scenario"]),
          .variant = any_text(from["variant"]),
          .engine = any_text(from["engine"]),
          .method = any_text(from["method"]),
          .step_us = number_or_null(from["step_us"]),
          .step_us_low = number_or_null(from["step_us_low"]),
          .step_us_high = number_or_null(from["step_us_high"]),
          .repetitions = static_cast<int>(from["repetitions"].number({0, 1e9}))};
}

}  // namespace

Report report_from(nlohmann::json json, const std::string& file) {
  const JsonReader from(json, file);
  from.must_have("plumb");
  const auto version = static_cast<int>(from["plumb"].number({1, report_format}));
  if (version < report_format) update_report(json, version);
  for (const char* key : {"command", "environment", "engines", "runs", "timings"}) from.must_have(key);
  Report report{.command = text_list_from(from["command"]), .environment = text_map_from(from["environment"])};
  for_each_entry(from["engines"], {"name", "source", "word", "exact"}, [&](const JsonReader& engine) {
    report.engines.push_back({.name = any_text(engine["name"]),
                              .source = any_text(engine["source"]),
                              .word = any_text(engine["word"]),
                              .exact = engine["exact"].boolean()});
  });
  for_each_entry(
      from["runs"],
      {"scenario", "variant", "engine", "method", "exact", "dt", "verdict", "metrics", "truth", "invariants"},
      [&](const JsonReader& run) { report.runs.push_back(run_record_from(run)); });
  const JsonReader timings = from["timings"];
  timings.must_have("steps");
  for_each_entry(timings["steps"],
                 {"scenario", "variant", "engine", "method", "step_us", "step_us_low", "step_us_high", "repetitions"},
                 [&](const JsonReader& timing) { report.timings.push_back(timing_from(timing)); });
  return report;
}

double number_or_null(const JsonReader& from) {
  constexpr double most = std::numeric_limits<double>::max();
  return from.value().is_null() ? std::numeric_limits<double>::quiet_NaN() : from.number({-most, most});
}

std::string any_text(const JsonReader& from) {
  constexpr std::size_t longest = 4096;
  return from.text(0, longest);
}

std::vector<std::string> text_list_from(const JsonReader& from) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < from.list(); ++i) all.push_back(any_text(from[i]));
  return all;
}

std::map<std::string, std::string> text_map_from(const JsonReader& from) {
  std::map<std::string, std::string> all;
  for_each_member(from, [&](const std::string& name, const JsonReader& text) { all[name] = any_text(text); });
  return all;
}

Verdict verdict_from(const JsonReader& from) {
  constexpr std::array all{Verdict::right,       Verdict::coarse,         Verdict::wrong,         Verdict::plausible,
                           Verdict::no_evidence, Verdict::beyond_horizon, Verdict::not_supported, Verdict::failed};
  static const auto names = names_of(all);
  return from.one_of<Verdict>(names);
}

CheckStatus check_status_from(const JsonReader& from) {
  constexpr std::array all{CheckStatus::held, CheckStatus::broken, CheckStatus::not_reported,
                           CheckStatus::not_applicable};
  static const auto names = names_of(all);
  return from.one_of<CheckStatus>(names);
}

void for_each_member(const JsonReader& object, const std::function<void(const std::string&, const JsonReader&)>& take) {
  if (!object.value().is_object()) object.expected("an object");
  for (const auto& member : object.value().items()) take(member.key(), object[member.key().c_str()]);
}

void for_each_entry(const JsonReader& list, std::initializer_list<const char*> keys,
                    const std::function<void(const JsonReader&)>& take) {
  for (std::size_t i = 0; i < list.list(); ++i) {
    const JsonReader entry = list[i];
    for (const char* key : keys) entry.must_have(key);
    take(entry);
  }
}

void rename_key(nlohmann::json& object, const char* old_key, const char* new_key) {
  if (!object.is_object() || !object.contains(old_key) || object.contains(new_key)) return;
  nlohmann::json value = std::move(object[old_key]);
  object.erase(old_key);
  object[new_key] = std::move(value);
}

void update_check(nlohmann::json& check) {
  rename_key(check, "standing", "status");
  rename_key(check, "allowed", "tolerance");
  if (check.is_object() && check.contains("status") && check["status"] == "not revealed")
    check["status"] = "not reported";
}

}  // namespace plumb
