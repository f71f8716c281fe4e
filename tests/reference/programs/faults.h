#pragma once

#include <fmt/format.h>

#include <ostream>
#include <string>

/// The ways in which faulty.sh misbehaves, once it has said who it is.
namespace plumb {

struct ProgramFault {
  const char* name;
  const char* reason;          // that Plumb gives, in part
  const char* timeout = "20";  // s, of which a busy machine may take some to start it
};

inline void PrintTo(const ProgramFault& fault, std::ostream* out) { *out << fault.name; }

/// "exec:sh .../faulty.sh FAULT"; `source`: the folder of Plumb's sources.
inline std::string faulty_program(const std::string& source, const std::string& fault) {
  return fmt::format("exec:sh {}/tests/reference/programs/faulty.sh {}", source, fault);
}

constexpr ProgramFault program_faults[] = {
    {"crash", "ended by signal 11"},
    {"abort", "its log ends: assertion failed: x > 0"},
    {"exits-with-0", "ended with exit code 0 although it was not asked to"},
    {"exits-with-3", "exit code 3 although it was not asked to; its log ends: no more"},
    {"hangs", "did not answer within 0.3 s", "0.3"},
    {"garbage", "its answer: line 1"},
    {"half-a-line", "ended with exit code 0"},
    {"no-object", "expected an object"},
    {"bad-utf8", "its answer: line 1"},
    {"nan", "its answer: line 1"},
    {"null", "states[0][0]: expected a number"},
    {"infinite", "states[0][0]"},
    {"diverges", "diverged at"},
    {"no-bodies", "states: expected the states of 1 bodies"},
    {"too-many-bodies", "states: expected the states of 1 bodies"},
    {"five-numbers", "states[0]: expected 6 numbers"},
    {"words", "states[0][0]: expected a number"},
    {"packed-nan", "states: number 3 is nan"},
    {"packed-five", "states: expected a list, or base64 of rows"},
    {"packed-too-many", "states: expected the states of 1 bodies"},
    {"packed-garbage", "states: expected a list, or base64"},
    {"no-time", "ns"},
    {"negative-time", "ns: "},
    {"lies-about-time", "it says that its steps took 1e+04 s, but only"},
    {"contact-of-nobody", "contact 0 is of body 7, but there are 1"},
    {"contact-without-direction", "a normal of length 1"},
    {"says-too-much", "step: expected 2"},
    {"skips-a-step", "step: expected 2"},
    {"says-error", "it says: my solver gave up"},
    {"closes-output", "it closed its standard output"},
    {"floods", "more than 16 MiB"},
    {"states-nonsense", "stepping.skin"},
    {"crashes-when-asked-how", "ended by signal 11"},
    {"crashes-in-build", "ended by signal 11"}};

}  // namespace plumb
