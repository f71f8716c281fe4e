#include "reports/history/moment.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

namespace plumb {
namespace {

using std::chrono::days;
using std::chrono::sys_days;

// Reads what a pattern asks for: 0 stands for a digit, all else for itself. Gives the numbers, one for each run of
// digits.
std::optional<std::array<int, 6>> numbers(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return std::nullopt;
  std::array<int, 6> found{};
  std::size_t at = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (pattern[i] != '0') {
      if (text[i] != pattern[i]) return std::nullopt;
      ++at;
    } else {
      if (text[i] < '0' || text[i] > '9') return std::nullopt;
      found[at] = 10 * found[at] + (text[i] - '0');
    }
  }
  return found;
}

// s, east of Greenwich.
std::optional<int> offset_of(std::string_view text) {
  if (text == "Z") return 0;
  for (const auto& [pattern, sign] : {std::pair{"+00:00", 1}, std::pair{"-00:00", -1}}) {
    const auto found = numbers(text, pattern);
    if (found && (*found)[1] < 24 && (*found)[2] < 60) return sign * (3600 * (*found)[1] + 60 * (*found)[2]);
  }
  return std::nullopt;
}

std::optional<std::string> read(std::string_view text) {
  constexpr std::string_view date = "0000-00-00", time = "0000-00-00T00:00:00";
  const auto found = text.size() == date.size() ? numbers(text, date) : numbers(text.substr(0, time.size()), time);
  const auto offset = text.size() <= time.size() ? std::optional(0) : offset_of(text.substr(time.size()));
  if (!found || !offset || text.size() == time.size()) return std::nullopt;
  const auto [year, month, day, hour, minute, second] = *found;
  const std::chrono::year_month_day asked{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                          std::chrono::day(static_cast<unsigned>(day))};
  if (!asked.ok() || hour > 23 || minute > 59 || second > 59) return std::nullopt;

  const auto moment =
      sys_days(asked) + std::chrono::seconds(3600 * hour + 60 * minute + second) - std::chrono::seconds(*offset);
  const auto midnight = std::chrono::floor<days>(moment);
  const std::chrono::year_month_day on(midnight);
  const auto since = (moment - midnight).count();
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(on.year()),
                     static_cast<unsigned>(on.month()), static_cast<unsigned>(on.day()), since / 3600, since / 60 % 60,
                     since % 60);
}

}  // namespace

std::string utc(std::string_view text) {
  if (auto moment = read(text)) return *moment;
  throw std::invalid_argument(
      fmt::format("\"{}\" is no moment; write 2026-11-21, 2026-11-21T09:06:10Z or 2026-11-21T10:06:10+01:00", text));
}

}  // namespace plumb
