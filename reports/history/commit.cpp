#include "reports/history/commit.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reports/system/processes.h"

namespace plumb {
namespace {

using std::chrono::days;
using std::chrono::sys_days;

// Matches a pattern in which 0 stands for a digit and other characters for themselves. Returns the number of each run
// of digits.
std::optional<std::array<int, 6>> match_digits(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return std::nullopt;
  std::array<int, 6> found{};
  std::size_t group = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (pattern[i] != '0') {
      if (text[i] != pattern[i]) return std::nullopt;
      ++group;
    } else {
      if (text[i] < '0' || text[i] > '9') return std::nullopt;
      found[group] = 10 * found[group] + (text[i] - '0');
    }
  }
  return found;
}

// s, east of UTC.
std::optional<int> offset_of(std::string_view text) {
  if (text == "Z") return 0;
  for (const auto& [pattern, sign] : {std::pair{"+00:00", 1}, std::pair{"-00:00", -1}}) {
    const auto found = match_digits(text, pattern);
    if (found && (*found)[1] < 24 && (*found)[2] < 60) return sign * (3600 * (*found)[1] + 60 * (*found)[2]);
  }
  return std::nullopt;
}

using TimePoint = std::chrono::sys_seconds;

std::optional<TimePoint> time_point_of(std::string_view text) {
  constexpr std::string_view date = "0000-00-00", time = "0000-00-00T00:00:00";
  const auto found =
      text.size() == date.size() ? match_digits(text, date) : match_digits(text.substr(0, time.size()), time);
  const auto offset = text.size() <= time.size() ? std::optional(0) : offset_of(text.substr(time.size()));
  if (!found || !offset || text.size() == time.size()) return std::nullopt;
  const auto [year, month, day, hour, minute, second] = *found;
  const std::chrono::year_month_day given{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                          std::chrono::day(static_cast<unsigned>(day))};
  if (!given.ok() || hour > 23 || minute > 59 || second > 59) return std::nullopt;

  return sys_days(given) + std::chrono::seconds(3600 * hour + 60 * minute + second) - std::chrono::seconds(*offset);
}

std::string text_of(TimePoint time_point) {
  const auto midnight = std::chrono::floor<days>(time_point);
  const std::chrono::year_month_day on(midnight);
  const auto since = (time_point - midnight).count();
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(on.year()),
                     static_cast<unsigned>(on.month()), static_cast<unsigned>(on.day()), since / 3600, since / 60 % 60,
                     since % 60);
}

}  // namespace

std::optional<Commit> find_commit(const std::string& revision) {
  if (revision.starts_with('-')) return std::nullopt;  // git would read it as an option
  const std::string name = (revision.empty() ? "HEAD" : revision) + "^{commit}";
  // The hash alone, even if the commit has a tag.
  auto hash = revision.empty() ? output_of({"git", "describe", "--always", "--abbrev=40", "--exclude=*", "--dirty"})
                               : output_of({"git", "rev-parse", "--verify", name});
  const auto at = output_of({"git", "show", "--no-patch", "--format=%cI", name});
  if (!hash || !at) return std::nullopt;
  return Commit{std::move(*hash), utc(*at)};
}

std::string utc(std::string_view text) {
  if (const auto found = time_point_of(text)) return text_of(*found);
  throw std::invalid_argument(fmt::format(
      "\"{}\" is not a date or time; write 2026-11-21, 2026-11-21T09:06:10Z or 2026-11-21T10:06:10+01:00", text));
}

std::string days_before(std::string_view moment, int many) {
  return text_of(time_point_of(moment).value() - days(many));
}

}  // namespace plumb
