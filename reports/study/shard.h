#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/study/point.h"

namespace plumb {

/// The k-th of n parts of a study, k from 1.
struct Shard {
  int k = 1, n = 1;

  bool whole() const { return n == 1; }
  std::string name() const;  // "2/4"
  bool operator==(const Shard&) const = default;
};

/// "k/n". Throws std::invalid_argument for what is none.
Shard parse_shard(std::string_view text);

/// A variable of the environment, or null.
using Variable = std::function<const char*(const char* name)>;

/// What a Slurm array makes of this task; nothing outside of one. Throws std::invalid_argument for an array with gaps,
/// whose tasks do not know which of them they are.
std::optional<Shard> slurm_shard(const Variable&);

/// The units of points that are a shard's: every n-th, so that dear and cheap ones are spread.
std::vector<std::span<const Point>> share_of(const Shard&, const std::vector<std::span<const Point>>& units);

}  // namespace plumb
