#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.h"

namespace plumb {

/// One file format of a report. Joins Catalog<Writer> from its own file.
struct Writer {
  std::string name;  // "json"
  std::string file;  // "report.json"
  /// The text of the file, or nullopt and the reason in `why_not`.
  std::function<std::optional<std::string>(const Report&, std::string& why_not)> text;
};

/// A folder for results, created and tested for writing before anything runs.
class OutputFolder {
 public:
  /// Creates the folder if it is missing. Throws std::invalid_argument, with the system's reason, if it cannot be
  /// written to.
  explicit OutputFolder(std::filesystem::path folder);

  struct Skipped {
    std::string file;
    std::string why;
  };
  struct Written {
    std::vector<std::filesystem::path> files;
    std::vector<Skipped> skipped;
  };

  /// Writes every format's file: first all under temporary names, then each is moved into place. Throws FileError if
  /// that fails; existing files are then left as they were.
  Written write(const Report&) const;

  /// The same for any files, as pairs of a name, which may begin with a folder, and contents.
  std::vector<std::filesystem::path> put(const std::vector<std::pair<std::string, std::string>>& files) const;

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace plumb
