#include "reports/history/snapshot.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "reports/history/commit.h"
#include "reports/run/report_json.h"
#include "reports/system/hash.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// What a version of the line calls its parts. The version grows when a reader of the previous one would misread it.
struct LineFormat {
  int version = 0;
  const char* runs;
  const char* engine;
  const char* worst_ratio;
};

constexpr LineFormat first_format{1, "answers", "contender", "share_of_allowed"};
constexpr LineFormat line_format{2, "runs", "engine", worst_ratio_metric};

// Makes -0 a 0, as the database does.
double plain(double value) { return value + 0.0; }

Json json_of(const Subject& subject, const SnapshotRun& run, const LineFormat& format) {
  Json json{{"scenario", subject.scenario},  {"variant", subject.variant},
            {format.engine, subject.engine}, {"dt", subject.dt},
            {"verdict", run.verdict},        {"metrics", Json::object()}};
  std::map<std::string, Measured> metrics = run.metrics;
  if (auto ratio = metrics.extract(worst_ratio_metric)) {
    ratio.key() = format.worst_ratio;
    metrics.insert(std::move(ratio));
  }
  for (const auto& [name, measured] : metrics) json["metrics"][name] = {plain(measured.value), measured.unit};
  if (run.time) {
    const auto& [median, low, high, repetitions] = *run.time;
    json["step_us"] = {plain(median), plain(low), plain(high), repetitions};
  }
  return json;
}

std::string line_of(const Snapshot& snapshot, const LineFormat& format) {
  Json json{{"plumb_history", format.version},
            {"commit", snapshot.commit},
            {"at", snapshot.at},
            {"command", snapshot.command},
            {"environment", Json(snapshot.environment)},
            {format.runs, Json::array()}};
  for (const auto& [subject, run] : snapshot.runs) json[format.runs].push_back(json_of(subject, run, format));
  // Text that is not UTF-8 comes only from a damaged history. It must not throw here: the hash will differ.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void update_line(nlohmann::json& line) {
  rename_key(line, first_format.runs, line_format.runs);
  if (!line.contains(line_format.runs) || !line[line_format.runs].is_array()) return;
  for (nlohmann::json& run : line[line_format.runs]) {
    rename_key(run, first_format.engine, line_format.engine);
    if (run.is_object() && run.contains("metrics")) {
      rename_key(run["metrics"], first_format.worst_ratio, line_format.worst_ratio);
    }
  }
}

constexpr double most = std::numeric_limits<double>::max();

// The number at `index` of a list of `size` values.
double number_in(const JsonReader& list, std::size_t index, std::size_t size) {
  if (list.list() != size) list.expected(fmt::format("a list of {}", size));
  return list[index].number({-most, most});
}

SnapshotRun run_of_line(const JsonReader& from) {
  SnapshotRun run{.verdict = any_text(from["verdict"])};
  for_each_member(from["metrics"], [&](const std::string& name, const JsonReader& metric) {
    if (metric.list() != 2) metric.expected("a value and a unit");
    run.metrics[name] = {number_or_null(metric[std::size_t{0}]), any_text(metric[std::size_t{1}])};
  });
  if (from.has("step_us")) {
    const JsonReader time = from["step_us"];
    run.time = {number_in(time, 0, 4), number_in(time, 1, 4), number_in(time, 2, 4),
                static_cast<int>(time[std::size_t{3}].number({0, 1e9}))};
  }
  return run;
}

SnapshotRun run_of_report(const RunRecord& record) {
  SnapshotRun run{.verdict = name_of(record.verdict), .metrics = record.metrics};
  if (const auto ratio = worst_error_ratio(record)) {
    constexpr double not_finite = std::numeric_limits<double>::quiet_NaN();
    run.metrics[worst_ratio_metric] = {std::isfinite(*ratio) ? *ratio : not_finite, "1"};
  }
  return run;
}

std::optional<StepTime> time_of(const Timing& timing) {
  const bool finite =
      std::isfinite(timing.step_us) && std::isfinite(timing.step_us_low) && std::isfinite(timing.step_us_high);
  if (!finite) return std::nullopt;
  return StepTime{timing.step_us, timing.step_us_low, timing.step_us_high, timing.repetitions};
}

constexpr std::string_view seal = ",\"sha256\":\"";

// The line without its hash, if it has one.
std::string unsealed(const std::string& line, const std::string& name) {
  const std::size_t end = line.rfind(seal);
  if (end == std::string::npos) return line;
  const std::string_view given = std::string_view(line).substr(end + seal.size());
  std::string whole = line.substr(0, end) + "}";
  if (given == sha256(whole) + "\"}") return whole;
  throw std::invalid_argument(name + ": was changed since it was exported: its sha256 is another");
}

}  // namespace

std::string to_line(const Snapshot& snapshot) { return line_of(snapshot, line_format); }

std::string id_of(const Snapshot& snapshot) { return sha256(to_line(snapshot)); }

std::string old_id_of(const Snapshot& snapshot) { return sha256(line_of(snapshot, first_format)); }

std::string to_sealed_line(const Snapshot& snapshot) {
  const std::string line = to_line(snapshot);
  return line.substr(0, line.size() - 1) + std::string(seal) + sha256(line) + "\"}";
}

Snapshot snapshot_of_line(const std::string& sealed, const std::string& name) {
  const std::string line = unsealed(sealed, name);
  nlohmann::json json = parse_json(line, name);
  const JsonReader from(json, name);
  from.must_have("plumb_history");
  if (from["plumb_history"].number({1, line_format.version}) < line_format.version) update_line(json);
  from.object({"plumb_history", "commit", "at", "command", "environment", line_format.runs});
  Snapshot snapshot{.commit = any_text(from["commit"]),
                    .at = any_text(from["at"]),
                    .command = text_list_from(from["command"]),
                    .environment = text_map_from(from["environment"])};
  if (utc(snapshot.at) != snapshot.at) from["at"].expected("a time in UTC, " + utc(snapshot.at));
  for_each_entry(from[line_format.runs], {}, [&](const JsonReader& run) {
    run.object({"scenario", "variant", line_format.engine, "dt", "verdict", "metrics"}, {"step_us"});
    const Subject subject{any_text(run["scenario"]), any_text(run["variant"]), any_text(run[line_format.engine]),
                          plain(run["dt"].number({0, most, "s"}))};
    if (!snapshot.runs.emplace(subject, run_of_line(run)).second) run.refuse("is there twice");
  });
  return snapshot;
}

Snapshot snapshot_of_report(const std::string& text, const std::string& name) {
  const Report report = report_from(parse_json(text, name), name);
  Snapshot snapshot{.command = report.command, .environment = report.environment};
  // Times do not name a time step: each belongs to the only run with its names.
  std::map<std::tuple<std::string, std::string, std::string>, SnapshotRun*> run_called;
  for (const RunRecord& run : report.runs) {
    const std::string engine = label_of(run.engine, run.method);
    const auto [found, added] =
        snapshot.runs.emplace(Subject{run.scenario, run.variant, engine, run.dt}, run_of_report(run));
    if (!added) {
      throw std::invalid_argument(
          fmt::format("{}: the run of {} {}, {} is there twice", name, run.scenario, run.variant, engine));
    }
    run_called[{run.scenario, run.variant, engine}] = &found->second;
  }
  for (const Timing& timing : report.timings) {
    const std::string engine = label_of(timing.engine, timing.method);
    const auto run = run_called.find({timing.scenario, timing.variant, engine});
    if (run == run_called.end()) {
      throw std::invalid_argument(
          fmt::format("{}: there is a time but no run of {} {}, {}", name, timing.scenario, timing.variant, engine));
    }
    run->second->time = time_of(timing);
  }
  return snapshot;
}

}  // namespace plumb
