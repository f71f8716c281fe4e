#include "reports/output.h"

#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "reports/writer.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// A file that goes away again unless it is put in place.
class Temporary {
 public:
  explicit Temporary(const fs::path& place) : place_(place), path_(place.string() + ".part") {}
  Temporary(Temporary&& other) noexcept
      : place_(std::move(other.place_)), path_(std::move(other.path_)), ours_(std::exchange(other.ours_, false)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (ours_) fs::remove(path_, ignored);
  }

  bool write(const std::string& text) {
    std::ofstream out(path_, std::ios::binary | std::ios::trunc);
    ours_ = out.is_open();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    return out.good();
  }

  fs::path put_in_place() {
    fs::rename(path_, place_);
    ours_ = false;
    return place_;
  }

 private:
  fs::path place_, path_;
  bool ours_ = false;
};

}  // namespace

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  const std::string place = "output folder \"" + folder_.string() + "\"";
  if (error) throw std::invalid_argument(place + " cannot be made: " + error.message());
  if (!fs::is_directory(folder_)) throw std::invalid_argument(place + " is not a folder");
  if (!Temporary(folder_ / "report").write("")) {
    throw std::invalid_argument(place + " cannot be written to; choose another with --out");
  }
}

OutputFolder::Written OutputFolder::write(const Report& report) const {
  Written written;
  std::vector<Temporary> ready;
  for (const Writer* writer : Catalog<Writer>::all()) {
    std::string why_not;
    const auto text = writer->text(report, why_not);
    if (!text) {
      written.skipped.push_back({writer->file, why_not});
      continue;
    }
    const fs::path place = folder_ / writer->file;
    ready.emplace_back(place);
    if (!ready.back().write(*text)) throw std::runtime_error("cannot write \"" + place.string() + "\"");
  }
  for (Temporary& file : ready) written.files.push_back(file.put_in_place());
  return written;
}

}  // namespace plumb
