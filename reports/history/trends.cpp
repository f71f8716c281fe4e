#include "reports/history/trends.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int page_format = 2;  // version of the document

// What step times depend on besides the code.
std::string machine_of(const SnapshotHead& head) {
  std::string all;
  for (const char* key : {"processor", "processors", "system", "compiler", "flags", "build_type"}) {
    const auto found = head.environment.find(key);
    if (found != head.environment.end()) all += (all.empty() ? "" : ", ") + (key + (": " + found->second));
  }
  return all;
}

bool is_noisy(const Series& series) { return series.metric == step_time; }

Trend trend_of(Series series, std::string machine) {
  std::vector<double> values;
  for (const Series::Value& value : series.values) values.push_back(value.value);
  auto changes = is_noisy(series) ? noisy_changes(values) : exact_changes(values);
  return {std::move(series), std::move(machine), std::move(changes)};
}

Json json_of(const Subject& subject) {
  return {{"scenario", subject.scenario}, {"variant", subject.variant}, {"engine", subject.engine}, {"dt", subject.dt}};
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

// "2026-11-21 04574af1c2": the date and the start of the commit.
std::string short_name(const SnapshotHead& head) {
  const bool dirty = head.commit.ends_with("-dirty");
  return fmt::format("{} {}{}", head.at.substr(0, 10), head.commit.substr(0, 10), dirty ? "-dirty" : "");
}

constexpr std::size_t widest = 60;  // columns of a chart; older values are left out

std::string name_of(const Subject& subject) {
  return fmt::format("{} {}, {}, dt {:.4g}", subject.scenario, subject.variant, subject.engine, subject.dt);
}

std::string name_of(const Series& series) { return name_of(series.subject) + ": " + series.metric; }

// "+4.2 %", or "from 0".
std::string relative_change(const ChangePoint& change) {
  if (change.before == 0) return "from 0";
  return fmt::format("{:+.3g} %", 100 * (change.after - change.before) / std::abs(change.before));
}

// " m"; "" for the unit "1".
std::string spaced(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

std::string line_of(const ChangePoint& change, const std::string& unit) {
  return fmt::format("{:.4g} -> {:.4g}{} ({}, {})", change.before, change.after, spaced(unit), relative_change(change),
                     change.p == 0 ? "exact" : fmt::format("p {:.3g}", change.p));
}

double size_of(const ChangePoint& change) {
  const double least = std::min(std::abs(change.before), std::abs(change.after));
  return least == 0 ? std::numeric_limits<double>::infinity() : std::abs(change.after - change.before) / least;
}

// One column for each value, scaled between the lowest and the highest.
std::string chart_of(const std::vector<Series::Value>& values) {
  constexpr std::array<const char*, 8> heights{"\u2581", "\u2582", "\u2583", "\u2584",
                                               "\u2585", "\u2586", "\u2587", "\u2588"};
  const auto first = values.end() - static_cast<std::ptrdiff_t>(std::min(values.size(), widest));
  const auto [low, high] = std::minmax_element(
      first, values.end(), [](const Series::Value& a, const Series::Value& b) { return a.value < b.value; });
  std::string text;
  for (auto value = first; value != values.end(); ++value) {
    const double share = high->value > low->value ? (value->value - low->value) / (high->value - low->value) : 0;
    text += heights[static_cast<std::size_t>(std::min(7.0, 8 * share))];
  }
  return text;
}

}  // namespace

std::vector<Trend> trends_of(const std::vector<SnapshotHead>& heads, const std::vector<Series>& all) {
  std::vector<Trend> trends;
  for (const Series& series : all) {
    std::map<std::string, Series> by_machine;
    for (const Series::Value& value : series.values) {
      if (!std::isfinite(value.value)) continue;
      const std::string machine = is_noisy(series) ? machine_of(heads[value.snapshot]) : "";
      Series& one =
          by_machine.try_emplace(machine, Series{series.subject, series.metric, series.unit, {}}).first->second;
      one.values.push_back(value);
    }
    for (auto& [machine, one] : by_machine) trends.push_back(trend_of(std::move(one), machine));
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

std::string text_of(const std::vector<SnapshotHead>& heads) {
  std::string text;
  for (const SnapshotHead& head : heads) {
    text += fmt::format("{}  {}  {:<46}", head.id.substr(0, 12), head.at, head.commit);
    for (const auto& [verdict, count] : head.verdicts) text += fmt::format("  {} {}", count, verdict);
    text += "\n";
  }
  return text;
}

std::string text_of(const std::vector<SnapshotHead>& heads, const std::vector<Trend>& trends,
                    const std::vector<VerdictChange>& verdicts, const std::string& since) {
  struct Line {
    std::size_t snapshot;
    double size;
    std::string text;
  };
  std::vector<Line> lines;
  int unchanged = 0;
  int noisy = 0;
  std::size_t longest = 0;  // of the noisy series
  for (const VerdictChange& change : verdicts) {
    lines.push_back({change.snapshot, std::numeric_limits<double>::infinity(),
                     fmt::format("{}: {} -> {}", name_of(change.subject), change.before, change.after)});
  }
  for (const Trend& trend : trends) {
    unchanged += trend.changes.empty();
    if (is_noisy(trend.series)) {
      ++noisy;
      longest = std::max(longest, trend.series.values.size());
    }
    for (const ChangePoint& change : trend.changes) {
      lines.push_back({trend.series.values[change.at].snapshot, size_of(change),
                       name_of(trend.series) + " " + line_of(change, trend.series.unit)});
    }
  }
  std::erase_if(lines, [&](const Line& line) { return heads[line.snapshot].at < since; });
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return std::pair(b.snapshot, b.size) < std::pair(a.snapshot, a.size);
  });
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == 0 || lines[i].snapshot != lines[i - 1].snapshot) text += short_name(heads[lines[i].snapshot]) + "\n";
    text += "  " + lines[i].text + "\n";
  }
  if (!since.empty()) {
    const auto shown =
        std::count_if(heads.begin(), heads.end(), [&](const SnapshotHead& head) { return head.at >= since; });
    text += fmt::format("{} change{} in {} snapshot{} since {}. In all: ", lines.size(), lines.size() == 1 ? "" : "s",
                        shown, shown == 1 ? "" : "s", since);
  }
  text += fmt::format("{} snapshot{}; {} of {} series never change.", heads.size(), heads.size() == 1 ? "" : "s",
                      unchanged, trends.size());
  if (longest >= 2 * least_values) {
    text += fmt::format(" Chance alone would let about {1:.1g} of {0} series of step times look changed.", noisy,
                        noisy * change_level);
  } else if (noisy > 0) {
    text += fmt::format(" Step times scatter: their changes show from {} snapshots on.", 2 * least_values);
  }
  return text + "\n";
}

std::string text_of(const std::vector<SnapshotHead>& heads, const std::vector<Trend>& trends) {
  std::string text;
  for (const Trend& trend : trends) {
    const auto& values = trend.series.values;
    text += fmt::format("{}, {} values, {:.4g} ... {:.4g}{}\n  {}\n", name_of(trend.series), values.size(),
                        values.front().value, values.back().value, spaced(trend.series.unit), chart_of(values));
    if (!trend.machine.empty()) text += fmt::format("  {}\n", trend.machine);
    for (const ChangePoint& change : trend.changes) {
      text +=
          fmt::format("  {}  {}\n", short_name(heads[values[change.at].snapshot]), line_of(change, trend.series.unit));
    }
  }
  return text;
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
    if (is_noisy(trend.series)) {
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
          {"about", "Reports from commit to commit, and where they changed"},
          {"configuration", {{"level", change_level}}},
          {"command", "./plumb history page"},
          {"environment", heads.empty() ? Json::object() : Json(heads.back().environment)},
          {"results", std::move(points)},
          {"findings", {{"verdicts", std::move(verdicts)}, {"trends", std::move(numbers)}, {"unchanged", unchanged}}},
          {"timings", {{"results", Json::object()}, {"trends", std::move(times)}}}};
}

}  // namespace plumb
