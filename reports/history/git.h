#pragma once

#include <optional>
#include <string>

namespace plumb {

struct Commit {
  std::string hash;  // "-dirty" after it where files differ from it
  std::string at;    // when it was committed, see utc
};

/// What git says of a revision here, in the folder that Plumb was called in; of HEAD and what was changed since for "".
/// Nothing where there is no git, no repository or no such revision.
std::optional<Commit> find_commit(const std::string& revision);

}  // namespace plumb
