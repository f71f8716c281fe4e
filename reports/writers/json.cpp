#include "reports/writers/json.h"

#include <nlohmann/json.hpp>

#include "reports/run/report_json.h"
#include "reports/writers/output.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

template <class Items, class ToJson>
Json list(const Items& items, ToJson to) {
  Json all = Json::array();
  for (const auto& item : items) all.push_back(to(item));
  return all;
}

Json of(const std::map<std::string, Measured>& metrics) {
  Json all = Json::object();
  for (const auto& [name, measured] : metrics) all[name] = {{"value", measured.value}, {"unit", measured.unit}};
  return all;
}

Json phases_of(const TruthCheck& check) {
  if (!check.spread) return nullptr;
  const Spread& spread = *check.spread;
  return {{"count", spread.phases}, {"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

Json of(const TruthCheck& check) {
  Json json{{"body", check.body},
            {"quantity", check.quantity},
            {"unit", check.unit},
            {"time", check.time},
            {"relation", name_of(check.relation)},
            {"expected", check.expected},
            {"measured", check.measured},
            {"error", check.error},
            {"tolerance", check.tolerance},
            {"ratio", error_ratio(check.error, check.tolerance)},
            {"scale", check.scale},
            {"relative_error", relative_error(check)},
            {"evidence", is_evidence(check)},
            {"passed", check.passed},
            {"reported", check.reported},
            {"phases", phases_of(check)},
            {"source", check.source}};
  if (check.chance > 0) json["chance"] = check.chance;
  return json;
}

Json of(const InvariantCheck& check) {
  Json json{{"name", check.name},
            {"unit", check.unit},
            {"status", name_of(check.status)},
            {"value", check.value},
            {"tolerance", check.tolerance},
            {"ratio", check.ratio},
            {"scale", check.scale},
            {"evidence", is_evidence(check)},
            {"time", check.time},
            {"where", check.where}};
  if (check.phases > 1) json["phases"] = check.phases;
  if (!check.detail.empty()) json["detail"] = check.detail;
  return json;
}

Json of(const RunRecord& run) {
  return {{"scenario", run.scenario},
          {"variant", run.variant},
          {"parameters", Json(run.parameters)},
          {"engine", run.engine},
          {"method", run.method},
          {"exact", run.exact},
          {"dt", run.dt},
          {"status", name_of(run.status)},
          {"reason", run.reason},
          {"verdict", name_of(run.verdict)},
          {"metrics", of(run.metrics)},
          {"truth", list(run.truth, [](const TruthCheck& check) { return of(check); })},
          {"invariants", list(run.invariants, [](const InvariantCheck& check) { return of(check); })},
          {"not_a_test", list(not_tests(run), [](const NotATest& one) {
             return Json{{"what", one.what}, {"share", one.share}};
           })}};
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json of(const RelativeDifference& difference, double scale) {
  return {{"largest", difference.largest}, {"end", difference.end}, {"scale", scale}};
}

Json of(const std::optional<KeyDifferences>& key) {
  if (!key) return nullptr;
  return {{"energy", of(key->energy, key->energy_scale)},
          {"momentum", of(key->momentum, key->momentum_scale)},
          {"angular_momentum", of(key->angular_momentum, key->angular_momentum_scale)},
          {"resting", resting(*key)},
          {"rest_a", or_null(key->rest_a)},
          {"rest_b", or_null(key->rest_b)},
          {"overlap_a", or_null(key->overlap_a)},
          {"overlap_b", or_null(key->overlap_b)},
          {"diverged_at", or_null(key->diverged_at)}};
}

Json of(const Comparison& comparison) {
  return {{"scenario", comparison.scenario},
          {"variant", comparison.variant},
          {"a", comparison.a},
          {"b", comparison.b},
          {"verdict", name_of(comparison.verdict)},
          {"reason", comparison.reason},
          {"key_differences", of(comparison.key)},
          {"metrics", of(comparison.metrics)}};
}

Json of(const Timing& timing) {
  return {{"scenario", timing.scenario},
          {"variant", timing.variant},
          {"engine", timing.engine},
          {"method", timing.method},
          {"step_us", timing.step_us},
          {"step_us_low", timing.step_us_low},
          {"step_us_high", timing.step_us_high},
          {"real_time_factor", timing.real_time_factor},
          {"repetitions", timing.repetitions}};
}

Json of(const ScenarioNote& note) {
  return {
      {"name", note.name},
      {"question", note.question},
      {"parameters", list(note.parameters,
                          [](const Parameter& parameter) {
                            return Json{{"name", parameter.name}, {"unit", parameter.unit}, {"about", parameter.about}};
                          })},
      {"group", note.group}};
}

Json of(const GroupNote& note) { return {{"name", note.name}, {"title", note.title}, {"stake", note.stake}}; }

Json of(const SteppingNote& one) { return {{"method", one.method}, {"text", one.text}}; }

Json of(const EngineNote& note) {
  return {{"name", note.name},
          {"about", note.about},
          {"source", note.source},
          {"word", note.word},
          {"language", note.language},
          {"execution", name_of(note.execution)},
          {"exact", note.exact},
          {"caveats", note.caveats},
          {"states", list(note.states, [](const SteppingNote& one) { return of(one); })}};
}

Json of(const MetricNote& note) {
  return {{"name", note.name}, {"unit", note.unit}, {"definition", note.definition}, {"better", note.better}};
}

Json of(const InvariantNote& note) {
  return {{"name", note.name}, {"unit", note.unit}, {"definition", note.definition}};
}

const auto of_each = [](const auto& item) { return of(item); };

const Catalog<Writer>::Entry json_entry{{.name = "json",
                                         .file = "report.json",
                                         .text = [](const Report& report, std::string&) -> std::optional<std::string> {
                                           return to_json(report).dump(1) + "\n";
                                         }}};

}  // namespace

Json to_json(const Report& report) {
  return {{"plumb", report_format},
          {"title", report.title},
          {"command", report.command},
          {"environment", report.environment},
          {"scenarios", list(report.scenarios, of_each)},
          {"groups", list(report.groups, of_each)},
          {"engines", list(report.engines, of_each)},
          {"metrics", list(report.metrics, of_each)},
          {"invariants", list(report.invariants, of_each)},
          {"runs", list(report.runs, of_each)},
          {"comparisons", list(report.comparisons, of_each)},
          {"timings", {{"steps", list(report.timings, of_each)}, {"clock", Json(report.clock)}}}};
}

}  // namespace plumb
