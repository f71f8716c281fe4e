#include "reports/system/environment.h"

#include <fmt/core.h>
#include <sys/utsname.h>

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

#include <CLI/Version.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace plumb {
namespace {

// The value on the first line that begins with `key`, without separator, blanks and quotes; "unknown" if there is none.
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

// Identifies the sine and cosine in use: glibc has a version with fused multiply-adds and one without, selects it by
// the processor (sysdeps/x86_64/fpu/multiarch/ifunc-avx-fma4.h: FMA and AVX2), and their last bits differ.
std::string libm() {
  std::string name = "unknown";
#ifdef __GLIBC__
  name = std::string("glibc ") + gnu_get_libc_version();
#endif
#if defined(__x86_64__) || defined(__i386__)
  name += __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2") ? " with FMA" : " without FMA";
#endif
  return name;
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
          {"architecture", machine()},
          {"libm", libm()},
          {"system", lookup("/etc/os-release", "PRETTY_NAME") + ", " + machine()},
          {"processor", lookup("/proc/cpuinfo", "model name")},
          {"processors", std::to_string(std::thread::hardware_concurrency())}};
}

}  // namespace plumb
