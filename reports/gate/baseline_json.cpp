#include "reports/gate/baseline_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "reports/gate/report_json.h"
#include "reports/gate/words.h"
#include "reports/system/files.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int baseline_format = 1;  // grows when a reader of the old one would be misled
constexpr std::size_t largest_file = std::size_t{64} << 20;
constexpr const char* any = "any";

// A change of a bound in its third digit is no news.
double rounded(double bound) { return bound == 0 ? 0 : std::stod(fmt::format("{:.1e}", bound)); }

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json of(const KeptNumber& number) {
  Json json{{"value", number.value}, {"unit", number.unit}};
  if (number.status) {
    json["status"] = name_of(*number.status);
    json["tolerance"] = number.tolerance;
  }
  if (number.moves) json["moves"] = *number.moves == infinity ? Json(any) : Json(rounded(*number.moves));
  if (number.wavers) json["wavers"] = true;
  return json;
}

std::string text_of(const RunKey& key, const KeptRun& run) {
  Json neighbours = Json::array();
  for (const Verdict verdict : run.neighbours) neighbours.push_back(name_of(verdict));
  const auto line = [](const char* name, const Json& value) {
    return fmt::format("   \"{}\": {},\n", name, dumped(value));
  };
  std::string text = "  {\n";
  text += line("scenario", key.scenario) + line("variant", key.variant);
  text += line("engine", key.engine) + line("method", key.method);
  text += line("exact", run.exact) + line("verdict", name_of(run.verdict)) + line("reason", run.reason);
  text += line("neighbours", neighbours) + line("bits", run.bits);
  text += "   \"numbers\": {";
  const char* separator = "\n";
  for (const auto& [name, number] : run.numbers) {
    text += fmt::format("{}    {}: {}", separator, dumped(name), dumped(of(number)));
    separator = ",\n";
  }
  return text + "\n   }\n  }";
}

KeptNumber number_from(const JsonReader& from) {
  from.object({"value", "unit"}, {"status", "tolerance", "moves", "wavers"});
  KeptNumber number{.unit = any_text(from["unit"]), .value = number_or_null(from["value"])};
  if (from.has("status")) {
    number.status = check_status_from(from["status"]);
    from.must_have("tolerance");
    number.tolerance = number_or_null(from["tolerance"]);
  }
  if (from.has("moves")) {
    const JsonReader moves = from["moves"];
    number.moves = moves.value() == any ? infinity : moves.number({0, std::numeric_limits<double>::max()});
  }
  number.wavers = from.boolean("wavers", false);
  return number;
}

void run_from(const JsonReader& from, Baseline& baseline) {
  from.object(
      {"scenario", "variant", "engine", "method", "exact", "verdict", "reason", "neighbours", "bits", "numbers"});
  const RunKey key{any_text(from["scenario"]), any_text(from["variant"]), any_text(from["engine"]),
                   any_text(from["method"])};
  KeptRun run{.exact = from["exact"].boolean(),
              .verdict = verdict_from(from["verdict"]),
              .reason = any_text(from["reason"]),
              .bits = any_text(from["bits"])};
  const JsonReader neighbours = from["neighbours"];
  for (std::size_t i = 0; i < neighbours.list(); ++i) run.neighbours.insert(verdict_from(neighbours[i]));
  for_each_member(from["numbers"], [&](const std::string& name, const JsonReader& number) {
    run.numbers.emplace(name, number_from(number));
  });
  if (!baseline.runs.emplace(key, std::move(run)).second) from.refuse("the run of " + key.text() + " is there twice");
}

Baseline baseline_from(const JsonReader& from) {
  from.must_have("plumb_baseline");
  from["plumb_baseline"].number({baseline_format, baseline_format});
  from.object({"plumb_baseline", "dt", "all", "scenarios", "platform", "engines", "runs"});
  Baseline baseline{.dt = from["dt"].number({std::numeric_limits<double>::min(), 1, "s"}),
                    .all = from["all"].boolean(),
                    .platform = texts_from(from["platform"]),
                    .engines = texts_from(from["engines"])};
  const JsonReader words = from["scenarios"];
  for (std::size_t i = 0; i < words.list(); ++i) baseline.words.push_back(any_text(words[i]));
  const JsonReader runs = from["runs"];
  for (std::size_t i = 0; i < runs.list(); ++i) run_from(runs[i], baseline);
  return baseline;
}

nlohmann::json parsed(const std::string& path) { return parse_json(read_text(path, largest_file), path); }

}  // namespace

std::string to_text(const Baseline& baseline) {
  std::string text = fmt::format("{{\n \"plumb_baseline\": {},\n \"dt\": {},\n \"all\": {},\n \"scenarios\": {},\n",
                                 baseline_format, dumped(baseline.dt), baseline.all, dumped(baseline.words));
  text += fmt::format(" \"platform\": {},\n \"engines\": {},\n \"runs\": [", dumped(Json(baseline.platform)),
                      dumped(Json(baseline.engines)));
  const char* separator = "\n";
  for (const auto& [key, run] : baseline.runs) {
    text += separator + text_of(key, run);
    separator = ",\n";
  }
  return text + "\n ]\n}\n";
}

Baseline read_baseline(const std::string& path) {
  const nlohmann::json json = parsed(path);
  return baseline_from(JsonReader(json, path));
}

Baseline read_results(const std::string& path) {
  const nlohmann::json json = parsed(path);
  const JsonReader from(json, path);
  if (!json.is_object()) from.expected("a baseline or a report.json");
  if (json.contains("plumb_baseline")) return baseline_from(from);
  if (!json.contains("plumb") || !json.contains("runs")) {
    from.refuse("this is neither a baseline (plumb accept) nor a report.json (plumb run)");
  }
  Baseline baseline = baseline_of(report_from(from));
  std::set<std::string> cases;
  for (const auto& [key, run] : baseline.runs) cases.insert(key.scenario + ":" + key.variant);
  baseline.words.assign(cases.begin(), cases.end());
  return baseline;
}

}  // namespace plumb
