#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.h"

namespace plumb {

/// A folder that can be written to; made and tried before anything is run.
class OutputFolder {
 public:
  /// Creates the folder where it is missing. Throws std::invalid_argument, with the system's reason, when nothing can
  /// be written there.
  explicit OutputFolder(std::filesystem::path folder);

  struct Skipped {
    std::string file;
    std::string why;
  };
  struct Written {
    std::vector<std::filesystem::path> files;
    std::vector<Skipped> skipped;
  };

  /// Every writer's file, each under a temporary name first; only when all are there do they take their places.
  /// Throws std::runtime_error when that fails, and leaves what was there before.
  Written write(const Report&) const;

  /// The same for files of one's own: names and what they hold.
  std::vector<std::filesystem::path> put(const std::vector<std::pair<std::string, std::string>>& files) const;

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace plumb
