#include "reports/writers/output.h"

#include <stdexcept>
#include <system_error>
#include <utility>

#include "reports/system/files.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

}  // namespace

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  const std::string place = "output folder \"" + folder_.string() + "\"";
  if (error) throw std::invalid_argument(place + " cannot be created: " + error.message());
  if (!fs::is_directory(folder_)) throw std::invalid_argument(place + " is not a folder");
  if (!NewFile(folder_ / "report").write("")) {
    throw std::invalid_argument(place + " cannot be written to; choose another with --out");
  }
}

OutputFolder::Written OutputFolder::write(const Report& report) const {
  Written written;
  std::vector<std::pair<std::string, std::string>> files;
  for (const Writer* writer : Catalog<Writer>::all()) {
    std::string why_not;
    auto text = writer->text(report, why_not);
    if (text) {
      files.emplace_back(writer->file, std::move(*text));
    } else {
      written.skipped.push_back({writer->file, why_not});
    }
  }
  written.files = put(files);
  return written;
}

std::vector<fs::path> OutputFolder::put(const std::vector<std::pair<std::string, std::string>>& files) const {
  std::vector<NewFile> ready;
  for (const auto& [name, text] : files) {
    const fs::path place = folder_ / name;
    std::error_code ignored;  // then it cannot be written, which is told below
    fs::create_directories(place.parent_path(), ignored);
    ready.emplace_back(place);
    ready.back().write_all(text);
  }
  std::vector<fs::path> placed;
  for (NewFile& file : ready) placed.push_back(file.put_in_place());
  return placed;
}

}  // namespace plumb
