#pragma once

#include <span>
#include <string_view>

/// The engines of npm that Plumb brings an adapter for: the files of reference/programs/npm, and the helper that all
/// of them use, as they were when Plumb was built.
namespace plumb {

struct PackagedFile {
  std::string_view engine;  // "" for a file that belongs to every engine
  std::string_view name, text;
};

std::span<const PackagedFile> packaged_files();

}  // namespace plumb
