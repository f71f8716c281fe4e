#include "reports/environment.h"

#include <fmt/core.h>
#include <sys/utsname.h>

#include <CLI/Version.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace plumb {
namespace {

// The text after the first line that begins with `key`, its separator, blanks and quotes left out; "unknown" without.
std::string lookup(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const auto begin = line.find_first_not_of(" \t:=\"", key.size());
    const auto end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end + 1 - begin);
  }
  return "unknown";
}

std::string machine() {
  utsname names{};
  return uname(&names) == 0 ? names.machine : "unknown";
}

}  // namespace

const char* version() { return PLUMB_VERSION; }

std::map<std::string, std::string> environment() {
  return {{"plumb", version()},
          {"compiler", PLUMB_COMPILER},
          {"flags", PLUMB_FLAGS},
          {"build_type", PLUMB_BUILD_TYPE},
          {"cli11", CLI11_VERSION},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {"nlohmann_json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                        NLOHMANN_JSON_VERSION_PATCH)},
          {"system", lookup("/etc/os-release", "PRETTY_NAME") + ", " + machine()},
          {"processor", lookup("/proc/cpuinfo", "model name")},
          {"processors", std::to_string(std::thread::hardware_concurrency())}};
}

}  // namespace plumb
