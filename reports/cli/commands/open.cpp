#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "reports/cli/command_line.h"
#include "reports/system/processes.h"
#include "scenarios/catalog.h"

namespace plumb::commands::open {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> study_pages(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("study-") && name.ends_with(".html")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path page_at(const fs::path& place) {
  std::error_code ignored;
  if (fs::is_regular_file(place, ignored)) {
    if (place.extension() == ".html") return place;
    throw std::invalid_argument("\"" + place.string() + "\" is not a page; name a folder or an .html file");
  }
  if (fs::is_regular_file(place / "index.html", ignored)) return place / "index.html";
  const auto studies = study_pages(place);
  if (studies.size() == 1) return place / studies.front();
  const std::string where = "\"" + place.string() + "\"";
  if (!studies.empty()) {
    throw std::invalid_argument(fmt::format("{} contains {}; name one of them", where, fmt::join(studies, ", ")));
  }
  throw std::invalid_argument(fmt::format("there is no page in {}; plumb report --out {} writes one", where, where));
}

bool has_desktop() {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

int open(const std::string& place) {
  const std::string page = fs::absolute(page_at(place)).lexically_normal().string();
  fmt::print("{}\n", page);
  if (has_desktop()) start_program({"xdg-open", page});  // best effort: the path has been printed
  return 0;
}

const Catalog<Command>::Entry entry{{.name = "open",
                                     .about = "Print the path of the page, and open it if there is a desktop",
                                     .examples = "  plumb open                              the report in out/\n"
                                                 "  plumb open results                      in another folder\n"
                                                 "  plumb open results/study-speed.html     a study's page\n",
                                     .attach = [](CLI::App& app) {
                                       const auto place = std::make_shared<std::string>("out");
                                       app.add_option("place", *place, "The folder of a report or a study, or a page")
                                           ->capture_default_str()
                                           ->type_name("DIR");
                                       return [place] { return open(*place); };
                                     }}};

}  // namespace
}  // namespace plumb::commands::open
