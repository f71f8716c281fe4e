#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/report.h"

/// A moving picture of one case, all engines side by side in real time, for documents.
namespace plumb {

/// What is drawn one after the other, each an SVG. At most `longest` seconds of the case, `rate` frames a second.
struct Preview {
  static constexpr double rate = 12.5;  // 1/s; a whole number of the 1/100 s that a GIF counts in
  static constexpr double longest = 8;  // s

  std::vector<std::string> frames;
};

/// Of a report's first case. Throws std::invalid_argument, with every engine's reason, where no run has anything to
/// show.
Preview preview_of(const Report&);

/// Throws std::invalid_argument, with the cure, where ffmpeg, which makes the picture, is not installed.
void check_preview();

/// Makes the GIF. Throws std::invalid_argument where ffmpeg cannot; then there is no file.
void write_preview(const Preview&, const std::filesystem::path& file);

}  // namespace plumb
