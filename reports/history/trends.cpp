#include "reports/history/trends.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int page_format = 2;  // of the page's data

// What a time hangs on beside the code.
std::string machine_of(const SnapshotHead& head) {
  std::string all;
  for (const char* key : {"processor", "processors", "system", "compiler", "flags", "build_type"}) {
    const auto found = head.environment.find(key);
    if (found != head.environment.end()) all += (all.empty() ? "" : ", ") + (key + (": " + found->second));
  }
  return all;
}

Trend trend_of(Series series, std::string machine) {
  std::vector<double> values;
  for (const Series::Value& value : series.values) values.push_back(value.value);
  return {std::move(series), std::move(machine), change_points(values)};
}

Json json_of(const Subject& subject) {
  return {
      {"scenario", subject.scenario}, {"variant", subject.variant}, {"contender", subject.engine}, {"dt", subject.dt}};
}

// A point of a study's document.
Json json_of(const SnapshotHead& head) {
  return {{"key", head.id},
          {"ending", "done"},
          {"reason", ""},
          {"values", {{"commit", head.commit}, {"at", head.at}, {"verdicts", Json(head.verdicts)}}}};
}

Json json_of(const Trend& trend) {
  Json json = json_of(trend.series.subject);
  json["metric"] = trend.series.metric;
  json["unit"] = trend.series.unit;
  json["machine"] = trend.machine;
  for (const char* column : {"snapshots", "values", "low", "high", "changes"}) json[column] = Json::array();
  for (const Series::Value& value : trend.series.values) {
    json["snapshots"].push_back(value.snapshot);
    json["values"].push_back(value.value);
    json["low"].push_back(value.low);
    json["high"].push_back(value.high);
  }
  for (const ChangePoint& change : trend.changes) {
    json["changes"].push_back({{"at", change.at}, {"before", change.before}, {"after", change.after}, {"p", change.p}});
  }
  return json;
}

Json json_of(const VerdictChange& change) {
  Json json = json_of(change.subject);
  json["snapshot"] = change.snapshot;
  json["before"] = change.before;
  json["after"] = change.after;
  return json;
}

}  // namespace

std::vector<Trend> trends_of(const std::vector<SnapshotHead>& heads, const std::vector<Series>& all) {
  std::vector<Trend> trends;
  for (const Series& series : all) {
    std::map<std::string, Series> by_machine;
    for (const Series::Value& value : series.values) {
      if (!std::isfinite(value.value)) continue;
      const std::string machine = series.metric == step_time ? machine_of(heads[value.snapshot]) : "";
      Series& there =
          by_machine.try_emplace(machine, Series{series.subject, series.metric, series.unit, {}}).first->second;
      there.values.push_back(value);
    }
    for (auto& [machine, there] : by_machine) trends.push_back(trend_of(std::move(there), machine));
  }
  return trends;
}

std::vector<VerdictChange> verdict_changes(const std::vector<VerdictSeries>& all) {
  std::vector<VerdictChange> changes;
  for (const VerdictSeries& series : all) {
    for (std::size_t i = 1; i < series.values.size(); ++i) {
      const auto& before = series.values[i - 1].verdict;
      const auto& [snapshot, after] = series.values[i];
      if (before != after) changes.push_back({series.subject, snapshot, before, after});
    }
  }
  return changes;
}

Json history_document(const History& history) {
  const auto heads = history.heads();
  Json points = Json::array();
  Json numbers = Json::array();
  Json times = Json::array();
  Json verdicts = Json::array();
  int unchanged = 0;
  for (const SnapshotHead& head : heads) points.push_back(json_of(head));
  for (const Trend& trend : trends_of(heads, history.series())) {
    if (trend.series.metric == step_time) {
      times.push_back(json_of(trend));
    } else if (trend.changes.empty()) {
      ++unchanged;
    } else {
      numbers.push_back(json_of(trend));
    }
  }
  for (const VerdictChange& change : verdict_changes(history.verdicts())) verdicts.push_back(json_of(change));
  return {{"plumb", page_format},
          {"study", "history"},
          {"about", "What reports said from commit to commit, and where it changed"},
          {"configuration", {{"level", change_level}}},
          {"command", "./plumb history page"},
          {"environment", heads.empty() ? Json::object() : Json(heads.back().environment)},
          {"results", std::move(points)},
          {"findings", {{"verdicts", std::move(verdicts)}, {"trends", std::move(numbers)}, {"unchanged", unchanged}}},
          {"timings", {{"results", Json::object()}, {"trends", std::move(times)}}}};
}

}  // namespace plumb
