#pragma once

#include <filesystem>

namespace plumb {

/// Throws std::invalid_argument, with the cure, where take_pictures cannot work: Node.js is missing, or was when Plumb
/// was built.
void check_pictures();

/// Writes each chart of a page (a report's or a study's) as an SVG into a folder, and says how many. Throws
/// std::runtime_error where that fails.
void take_pictures(const std::filesystem::path& page, const std::filesystem::path& folder);

}  // namespace plumb
