#include "reports/history/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace plumb {
namespace {

constexpr std::size_t widest = 60;  // columns of a course; older values are left out

std::string name_of(const Subject& subject) {
  return fmt::format("{} {}, {}, dt {:.4g}", subject.scenario, subject.variant, subject.engine, subject.dt);
}

std::string name_of(const Series& series) { return name_of(series.subject) + ": " + series.metric; }

// "+4.2 %"; of what was 0 there is no share.
std::string by_how_much(const ChangePoint& change) {
  if (change.before == 0) return "from 0";
  return fmt::format("{:+.3g} %", 100 * (change.after - change.before) / std::abs(change.before));
}

// "1" is the unit of what has none.
std::string spaced(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

std::string line_of(const ChangePoint& change, const std::string& unit) {
  return fmt::format("{:.4g} -> {:.4g}{} ({}, {})", change.before, change.after, spaced(unit), by_how_much(change),
                     change.p == 0 ? "exact" : fmt::format("p {:.3g}", change.p));
}

double size_of(const ChangePoint& change) {
  const double least = std::min(std::abs(change.before), std::abs(change.after));
  return least == 0 ? std::numeric_limits<double>::infinity() : std::abs(change.after - change.before) / least;
}

// A column for each value, by its height between the lowest and the highest.
std::string course_of(const std::vector<Series::Value>& values) {
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

std::string short_name(const SnapshotHead& head) {
  const bool dirty = head.commit.ends_with("-dirty");
  return fmt::format("{} {}{}", head.at.substr(0, 10), head.commit.substr(0, 10), dirty ? "-dirty" : "");
}

std::string text_of(const std::vector<SnapshotHead>& heads) {
  std::string text;
  for (const SnapshotHead& head : heads) {
    text += fmt::format("{}  {}  {:<46}", head.id.substr(0, 12), head.at, head.commit);
    for (const auto& [verdict, many] : head.verdicts) text += fmt::format("  {} {}", many, verdict);
    text += "\n";
  }
  return text;
}

std::string text_of(const std::vector<SnapshotHead>& heads, const std::vector<Trend>& trends,
                    const std::vector<VerdictChange>& verdicts) {
  struct Line {
    std::size_t snapshot;
    double size;
    std::string text;
  };
  std::vector<Line> lines;
  int unchanged = 0;
  int noisy = 0;
  for (const VerdictChange& change : verdicts) {
    lines.push_back({change.snapshot, std::numeric_limits<double>::infinity(),
                     fmt::format("{}: {} -> {}", name_of(change.subject), change.before, change.after)});
  }
  for (const Trend& trend : trends) {
    unchanged += trend.changes.empty();
    noisy += trend.series.metric == step_time;
    for (const ChangePoint& change : trend.changes) {
      lines.push_back({trend.series.values[change.at].snapshot, size_of(change),
                       name_of(trend.series) + " " + line_of(change, trend.series.unit)});
    }
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return std::pair(b.snapshot, b.size) < std::pair(a.snapshot, a.size);
  });
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == 0 || lines[i].snapshot != lines[i - 1].snapshot) text += short_name(heads[lines[i].snapshot]) + "\n";
    text += "  " + lines[i].text + "\n";
  }
  text += fmt::format("{} snapshots; {} of {} series never change.", heads.size(), unchanged, trends.size());
  if (noisy > 0) {
    text +=
        fmt::format(" Of {} series of times, chance alone would let {:.1g} look changed.", noisy, noisy * change_level);
  }
  return text + "\n";
}

std::string courses(const std::vector<SnapshotHead>& heads, const std::vector<Trend>& trends) {
  std::string text;
  for (const Trend& trend : trends) {
    const auto& values = trend.series.values;
    text += fmt::format("{}, {} values, {:.4g} ... {:.4g}{}\n  {}\n", name_of(trend.series), values.size(),
                        values.front().value, values.back().value, spaced(trend.series.unit), course_of(values));
    if (!trend.machine.empty()) text += fmt::format("  {}\n", trend.machine);
    for (const ChangePoint& change : trend.changes) {
      text +=
          fmt::format("  {}  {}\n", short_name(heads[values[change.at].snapshot]), line_of(change, trend.series.unit));
    }
  }
  return text;
}

}  // namespace plumb
