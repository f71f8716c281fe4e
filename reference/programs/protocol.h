#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/simulation.h"

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

std::string ask_end();

}  // namespace plumb::protocol
