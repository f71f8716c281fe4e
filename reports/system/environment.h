#pragma once

#include <map>
#include <string>
#include <vector>

/// What a report was made with, and what its times depend on besides the code.
namespace plumb {

/// What a report was made with: Plumb, compiler, flags, build type, libraries, system, processor. The same in every run
/// on one machine.
std::map<std::string, std::string> environment();

/// Plumb's version, as `plumb --version` prints it.
const char* version();

/// What times depend on besides the code: environment(), the identity of the machine ("machine": of this boot), its
/// "governor" of clock rates, and its "load" average over a minute.
using TimingFacts = std::map<std::string, std::string>;
TimingFacts timing_facts();
/// The fact of that name, or "unknown".
std::string fact(const TimingFacts&, const char* key);

/// Why times from there and from here must not be compared: the machines differ. "" if they may be.
std::string machine_difference(const TimingFacts& there, const TimingFacts& here);

/// How the builds of two programs differ, in compiler, build type or flags, which changes times: "flags: -O2, now -O3".
std::vector<std::string> build_differences(const TimingFacts& before, const TimingFacts& now);

/// Whether more processes want to run than the machine has processors, so that times take longer to settle.
bool busy(const TimingFacts&);

}  // namespace plumb
