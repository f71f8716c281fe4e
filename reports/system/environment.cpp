#include "reports/system/environment.h"

#include <fmt/core.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <CLI/Version.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

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

std::string first_word(const char* file) {
  std::ifstream in(file);
  std::string word;
  return in >> word ? word : "unknown";
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

std::string fact(const TimingFacts& facts, const char* key) {
  const auto found = facts.find(key);
  return found == facts.end() ? "unknown" : found->second;
}

TimingFacts timing_facts() {
  TimingFacts facts = environment();
  facts["machine"] = first_word("/proc/sys/kernel/random/boot_id");
  facts["governor"] = first_word("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  facts["load"] = first_word("/proc/loadavg");
  return facts;
}

std::string machine_difference(const TimingFacts& there, const TimingFacts& here) {
  for (const char* const key : {"processor", "processors", "governor", "system", "machine"}) {
    const std::string a = fact(there, key);
    const std::string b = fact(here, key);
    if (a != b) return fmt::format("{} \"{}\" there, \"{}\" here", key, a, b);
  }
  return "";
}

std::vector<std::string> build_differences(const TimingFacts& before, const TimingFacts& now) {
  std::vector<std::string> differences;
  for (const char* const key : {"compiler", "build_type", "flags"}) {
    const std::string a = fact(before, key);
    const std::string b = fact(now, key);
    if (a != b) differences.push_back(fmt::format("{}: {}, now {}", key, a, b));
  }
  return differences;
}

bool busy(const TimingFacts& facts) {
  return std::atof(fact(facts, "load").c_str()) > std::atof(fact(facts, "processors").c_str());
}

}  // namespace plumb
