#pragma once

#include <string>
#include <string_view>

#include "reference/simulation.h"

/// Engines that are programs of their own, in any language, and speak plumb-engine 1 (see protocol.h). Plumb starts the
/// program, gives it the scene, and judges what it answers; whatever the program does, only its own runs fail.
namespace plumb {

/// How a command line names such an engine: exec:COMMAND.
constexpr std::string_view program_prefix = "exec:";

/// The engine that a command starts. The program is asked who it is the first time. It bears the name that it says, or
/// NAME@VERSION if that is taken, so that two versions of one engine can be compared. Its `word` is the one given, by
/// default exec:COMMAND. Throws std::invalid_argument if it does not answer as the protocol asks.
///
/// Each simulation has a process to itself while it lives; then another may build its scene in it. The engine has the
/// options of the program, and `timeout` and `memory`, beyond which it is ended.
const Engine& engine_of_program(const std::string& command, const std::string& word = "");

/// An engine of this program in a process of its own: `plumb engine serve NAME`, so that whatever it does, only its own
/// runs fail. It states the same of how it steps, supports the same and moves to the same bits; what it chooses by
/// itself is not known. Its runs are ended after a minute without answer.
const Engine& isolated(const Engine&);

/// The engine of a program that was named before, by its name; null if there is none.
const Engine* known_program(std::string_view name);

}  // namespace plumb
