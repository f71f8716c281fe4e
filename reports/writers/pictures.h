#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/report.h"

/// Pictures for documents: charts as SVG files, and an animation of a case.
namespace plumb {

/// Throws std::invalid_argument, with the cure, if take_pictures cannot work: Node.js is missing now, or was when Plumb
/// was built.
void check_pictures();

/// Writes each chart of a page (of a report or a study) to a folder as an SVG and prints how many. Throws
/// std::runtime_error if that fails.
void take_pictures(const std::filesystem::path& page, const std::filesystem::path& folder);

/// The frames of an animation of one case in real time, all engines side by side, each an SVG.
struct Preview {
  static constexpr double rate = 12.5;  // frames a second: a whole number of a GIF's units of 1/100 s
  static constexpr double longest = 8;  // s of the case

  std::vector<std::string> frames;
};

/// Of a report's first case. Throws std::invalid_argument, with every engine's reason, if no run has a trace to show.
Preview preview_of(const Report&);

/// Throws std::invalid_argument, with the cure, if ffmpeg is not installed, which makes the GIF.
void check_preview();

/// Makes the GIF. Throws std::invalid_argument if ffmpeg fails; there is no file then.
void write_preview(const Preview&, const std::filesystem::path& file);

}  // namespace plumb
