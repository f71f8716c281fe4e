#pragma once

#include <map>
#include <string>
#include <vector>

namespace plumb {

/// What a time hangs on besides the code: environment(), and the machine's identity ("machine": of this boot), its
/// "governor" of clock rates, and its "load" average over a minute.
using TimingFacts = std::map<std::string, std::string>;
TimingFacts timing_facts();
/// "unknown" where nothing is known of it.
std::string fact(const TimingFacts&, const char* key);

/// Why times from there and from here must not be compared; "" where they may.
std::string other_machine(const TimingFacts& there, const TimingFacts& here);

/// Compiler, flags and the like wherein two programs differ: "flags: -O2, now -O3". Times tell of these, too.
std::vector<std::string> built_otherwise(const TimingFacts& before, const TimingFacts& now);

/// Whether others use the machine so much that times take longer to settle: more at work than it has processors.
bool busy(const TimingFacts&);

}  // namespace plumb
