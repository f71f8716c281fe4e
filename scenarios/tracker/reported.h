#pragma once

#include <span>
#include <string_view>

/// Scenes that ask again what users of physics engines reported: the files *.json of this folder, as they were when
/// Plumb was built. They are no entries of the scenarios' catalogue, for like every scene file they state tolerances as
/// numbers, while a family derives its tolerances from each engine's stepping.
namespace plumb {

struct ReportedScene {
  std::string_view name;  // of the file, without ".json"
  std::string_view text;  // see scene_json.h
};

/// In the order of their names.
std::span<const ReportedScene> reported_scenes();

}  // namespace plumb
