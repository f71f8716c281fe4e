#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumb {

struct Commit {
  std::string hash;  // followed by "-dirty" if files differ from it
  std::string at;    // when it was committed, see utc
};

/// Asks git about a revision in the current folder; "" is HEAD with uncommitted changes. Returns nullopt if there is no
/// git, no repository or no such revision.
std::optional<Commit> find_commit(const std::string& revision);

/// A time in UTC as ISO 8601, "2026-11-21T09:06:10Z", so that times sort as text. Accepts a date, "2026-11-21" (its
/// midnight in UTC), or a date and a time with Z or an offset, "2026-11-21T10:06:10+01:00". Throws
/// std::invalid_argument for anything else.
std::string utc(std::string_view text);

/// The time that many days before another, both as `utc` gives them.
std::string days_before(std::string_view moment, int many);

}  // namespace plumb
