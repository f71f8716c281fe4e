#include "reports/timing/machine.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "reports/system/environment.h"

namespace plumb {
namespace {

std::string first_word(const char* file) {
  std::ifstream in(file);
  std::string word;
  return in >> word ? word : "unknown";
}

}  // namespace

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
