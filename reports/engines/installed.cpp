#include "reports/engines/installed.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "reference/programs/line_process.h"
#include "reference/programs/program_engine.h"
#include "reports/system/files.h"
#include "reports/system/processes.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view adapter = "adapter.mjs";
constexpr std::size_t largest_file = std::size_t{1} << 20;  // bytes

bool belongs_to(const PackagedFile& file, std::string_view engine) {
  return file.engine.empty() || file.engine == engine;
}

void check_name(const std::string& name) {
  std::vector<std::string> names;
  for (const PackagedEngine& engine : packaged_engines()) names.push_back(engine.name);
  if (std::ranges::find(names, name) == names.end()) throw std::invalid_argument(unknown("engine of npm", name, names));
}

// Whether every file is there as this Plumb would write it, and npm finished.
bool is_current(const std::string& name, const fs::path& place) {
  if (!fs::exists(place / "node_modules")) return false;
  return std::ranges::all_of(packaged_files(), [&](const PackagedFile& file) {
    const fs::path path = place / file.name;
    return !belongs_to(file, name) || (fs::exists(path) && read_text(path.string(), largest_file) == file.text);
  });
}

std::string node() {
  for (const char* name : {"node", "nodejs"}) {
    const auto version = output_of({name, "--version"});
    if (version && version->starts_with('v') && std::atoi(version->c_str() + 1) >= 18) return name;
  }
  throw std::invalid_argument("this engine needs Node.js 18 or newer, which was not found (Debian: nodejs npm)");
}

// A folder that is removed unless it is put in place.
class NewFolder {
 public:
  explicit NewFolder(fs::path place) : place_(std::move(place)) {
    path_ = place_.string() + fmt::format(".part-{}", getpid());
    fs::create_directories(path_);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  ~NewFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }
  void put_in_place() {
    fs::remove_all(place_);
    fs::rename(path_, place_);
  }

 private:
  fs::path place_, path_;
};

}  // namespace

std::vector<PackagedEngine> packaged_engines() {
  std::vector<PackagedEngine> all;
  for (const PackagedFile& file : packaged_files()) {
    if (file.name != "package.json") continue;
    all.push_back({std::string(file.engine), nlohmann::json::parse(file.text).value("description", "")});
  }
  return all;
}

fs::path engines_folder(const std::string& prefix) {
  if (!prefix.empty()) return fs::absolute(prefix);
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data != '\0') return fs::path(data) / "plumb" / "engines";
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0')
    throw std::invalid_argument("neither XDG_DATA_HOME nor HOME is set: give --prefix");
  return fs::path(home) / ".local" / "share" / "plumb" / "engines";
}

std::optional<std::string> command_of_installed(const std::string& name, const fs::path& folder) {
  const fs::path place = folder / name;
  if (!is_current(name, place)) return std::nullopt;
  return fmt::format("{} {}", node(), quoted_for_shell((place / adapter).string()));
}

bool install_engine(const std::string& name, const fs::path& folder) {
  check_name(name);
  if (is_current(name, folder / name)) return false;
  node();
  if (!find_program("npm")) throw std::invalid_argument("npm was not found, which installs " + name + " (Debian: npm)");
  NewFolder made(folder / name);
  for (const PackagedFile& file : packaged_files()) {
    if (!belongs_to(file, name)) continue;
    std::ofstream out(made.path() / file.name, std::ios::binary);
    if (!(out << file.text).flush())
      throw std::invalid_argument(fmt::format("{}: can't be written", made.path().string()));
  }
  const int code = run_program({"npm", "--prefix", made.path().string(), "ci", "--ignore-scripts", "--no-audit",
                                "--no-fund", "--loglevel=error"});
  if (code != 0) {
    throw std::invalid_argument(
        fmt::format("npm could not install {}: exit code {}, and what it says above. Is there a network?", name, code));
  }
  made.put_in_place();
  return true;
}

bool remove_engine(const std::string& name, const fs::path& folder) {
  check_name(name);
  return fs::remove_all(folder / name) > 0;
}

}  // namespace plumb
