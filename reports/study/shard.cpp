#include "reports/study/shard.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace plumb {
namespace {

constexpr int most_shards = 100000;

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::string Shard::name() const { return fmt::format("{}/{}", k, n); }

Shard parse_shard(std::string_view text) {
  const auto bar = text.find('/');
  if (bar != std::string_view::npos) {
    const auto k = whole_number(text.substr(0, bar));
    const auto n = whole_number(text.substr(bar + 1));
    if (k && n && *k >= 1 && *k <= *n && *n <= most_shards) return {*k, *n};
  }
  throw std::invalid_argument(fmt::format("--shard: \"{}\" should read k/n with 1 <= k <= n, as 1/4", text));
}

// Task numbers begin where the user had them begin, at 0 as often as at 1, and may go in steps: --array=0-6:2.
std::optional<Shard> slurm_shard(const Variable& variable) {
  if (variable("SLURM_ARRAY_TASK_ID") == nullptr) return std::nullopt;
  const auto read = [&](const char* name, std::optional<int> otherwise) {
    const char* text = variable(name);
    const auto number = text == nullptr ? otherwise : whole_number(text);
    if (!number) {
      throw std::invalid_argument(
          fmt::format("{}: \"{}\" is no whole number; give --shard k/n", name, text ? text : ""));
    }
    return *number;
  };
  const int id = read("SLURM_ARRAY_TASK_ID", std::nullopt);
  const int count = read("SLURM_ARRAY_TASK_COUNT", std::nullopt);
  const int first = read("SLURM_ARRAY_TASK_MIN", std::nullopt);
  const int step = read("SLURM_ARRAY_TASK_STEP", 1);
  const int last = read("SLURM_ARRAY_TASK_MAX", first + (count - 1) * step);
  const bool even = step > 0 && last == first + (count - 1) * step && (id - first) % step == 0;
  if (!even || id < first || id > last) {
    throw std::invalid_argument(
        fmt::format("the Slurm array has {} tasks from {} to {} with gaps; give --shard k/n", count, first, last));
  }
  return Shard{(id - first) / step + 1, count};
}

std::vector<std::span<const Point>> share_of(const Shard& shard, const std::vector<std::span<const Point>>& units) {
  std::vector<std::span<const Point>> share;
  const auto n = static_cast<std::size_t>(shard.n);
  for (std::size_t i = static_cast<std::size_t>(shard.k) - 1; i < units.size(); i += n) share.push_back(units[i]);
  return share;
}

}  // namespace plumb
