#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scenario.h"

namespace plumb {
class JsonReader;
}

/// plumb-engine 1: how Plumb speaks with an engine that is a program. Each ask and each answer is one line of JSON in
/// UTF-8. reference/programs/engine.schema.json defines them; reference/programs/README.md explains them.
///
/// Readers take an answer and throw std::invalid_argument if it is not what was asked for, naming the JSON path.
namespace plumb::protocol {

/// Who a program says it is.
struct Identity {
  std::string name, version, about, source, language;
  ExecutionKind execution = ExecutionKind::not_stated;
  std::vector<std::string> caveats;
  std::vector<Option> options;
  std::vector<WorkLadder> ladders;  // of the options that state one
};

std::string ask_hello();
Identity read_hello(std::string_view answer);

/// What it states about a method of its own.
std::string ask_stepping(const Settings&, double dt);
Stepping read_stepping(std::string_view answer, double dt);

/// Its words for that.
nlohmann::ordered_json stepping_as_json(const Stepping&);

/// The same back, of steps of dt seconds. Throws std::invalid_argument, naming the place, if anything is unknown or out
/// of range.
Stepping stepping_of(const JsonReader&, double dt);

/// Throws std::invalid_argument if the scene can't be written as a scene file.
std::string ask_build(const Scene&, const Settings&);

/// What follows a build, and each step.
struct Answer {
  std::string refusal;            // why the scene is not supported; if empty, it is
  std::vector<BodyState> states;  // in the scene's order
  std::vector<ContactState> contacts;
  double seconds = 0;  // inside the step alone, by the program's own clock
};

std::string write_start(std::span<const BodyState>);
Answer read_build(std::string_view answer, std::size_t bodies);

/// That many steps of dt seconds, each with an answer of its own, which bears the number of the step since the build.
std::string ask_steps(std::size_t count, double dt);
std::string write_step(std::size_t number, std::int64_t nanoseconds, std::span<const BodyState>,
                       std::span<const ContactState>);
Answer read_step(std::string_view answer, std::size_t bodies, std::size_t number);

/// What the answer to a step says, before it is compared with what was asked.
struct StepLine {
  std::uint64_t step = 0;
  double nanoseconds = 0;
  std::vector<double> states, contacts;  // rows of 6 and of 9 numbers in turn, all finite
};

/// Reads an answer to a step in a tenth of the time that a JSON document takes. False if it is anything else than such
/// an answer, or says anything wrong: the parser of whole answers then finds out what.
bool scan_step_line(std::string_view line, StepLine&);

std::string ask_end();

/// How many steps a program is asked for at once. Many, for asking and waking up take longer than many a step; but no
/// more than are soon answered, so that a program that sends all its answers together is not taken to hang.
class StepsAhead {
 public:
  std::size_t count() const { return count_; }

  /// That many were asked for, and answered within that many seconds.
  void took(std::size_t steps, double seconds) {
    if (seconds > soon) count_ = least;
    if (seconds <= soon && steps == count_) count_ = std::min(2 * count_, most);
  }

 private:
  static constexpr std::size_t least = 64, most = 512;
  static constexpr double soon = 0.02;  // s

  std::size_t count_ = least;
};

}  // namespace plumb::protocol
