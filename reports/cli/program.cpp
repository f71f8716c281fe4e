#include "reports/cli/program.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "reports/cli/command_line.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

constexpr int wrong_usage = 2;
constexpr int internal_error = 3;

std::string defect_of(const Engine& engine) {
  if (engine.name.empty()) return "needs a name";
  if (engine.name.find_first_of(":,= ") != std::string::npos) return "must have a name without space, : , and =";
  if (!engine.stepping) return "does not state how it steps: Engine::stepping is empty";
  if (!engine.unsupported) return "does not say what it cannot run: Engine::unsupported is empty";
  return engine.build ? "" : "cannot build scenes: Engine::build is empty";
}

std::vector<std::string> flags_of(const CLI::App& app) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return flags;
}

std::vector<std::string> words_of(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* word : app.get_subcommands([](const CLI::App*) { return true; }))
    words.push_back(word->get_name());
  return words;
}

// The message of CLI11, or the nearest name if a word is unknown.
std::string advice(const CLI::App& app, const CLI::ParseError& error) {
  for (const CLI::App* command : app.get_subcommands()) {
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    const auto words = words_of(*command);
    for (const std::string& word : command->remaining()) {
      return words.empty() || word.rfind('-', 0) == 0 ? unknown("option", word, flags_of(*command))
                                                      : unknown(command->get_name(), word, words);
    }
  }
  for (const std::string& word : app.remaining()) {
    if (word.rfind('-', 0) == 0) return unknown("option", word, flags_of(app));
    return unknown("command", word, words_of(app));
  }
  return error.what();
}

// Without control characters, which file names may have, apart from line breaks.
std::string printable_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    out += printable(line, line.npos);
    text.remove_prefix(line.size());
    if (text.empty()) break;
    out += '\n';
    text.remove_prefix(1);
  }
  return out;
}

/// The program and the words of the command that was given, as in "plumb engine check".
std::string command_of(const CLI::App& app) {
  std::string words = "plumb";
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    words += " " + at->get_name();
  }
  return words;
}

/// Sets `command` as soon as it is known.
int parse_and_run(std::vector<std::string> arguments, std::string& command) {
  check_engines(Catalog<Engine>::all());
  CommandLine line;
  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 expects
  try {
    line.app().parse(arguments);
    command = command_of(line.app());
  } catch (const CLI::ParseError& error) {
    command = command_of(line.app());
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return line.app().exit(error);
    throw std::invalid_argument(advice(line.app(), error));
  }
  return line.run();
}

}  // namespace

void check_engines(std::span<const Engine* const> all) {
  const Engine* before = nullptr;
  for (const Engine* engine : all) {
    std::string defect = defect_of(*engine);
    if (before != nullptr && before->name == engine->name) defect = "is there twice: each needs a name of its own";
    if (!defect.empty()) throw std::invalid_argument("engine \"" + engine->name + "\" " + defect);
    before = engine;
  }
}

int program(std::vector<std::string> arguments) {
  const auto refuse = [](const std::string& why, int code, const std::string& hint = "") {
    fmt::print(stderr, "plumb: {}\n{}", printable_lines(why), hint);
    return code;
  };
  std::string command = "plumb";
  try {
    const int code = parse_and_run(std::move(arguments), command);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    return refuse(std::string("standard output cannot be written: ") + std::strerror(errno), wrong_usage);
  } catch (const std::invalid_argument& error) {
    return refuse(error.what(), wrong_usage, "See " + command + " --help.\n");
  } catch (const FileError& error) {
    return refuse(error.what(), wrong_usage);
  } catch (const std::filesystem::filesystem_error& error) {
    return refuse(error.path1().string() + ": " + error.code().message(), wrong_usage);
  } catch (const std::system_error& error) {
    // fmt throws it where standard output is full.
    const bool full = std::ferror(stdout) != 0;
    return refuse(full ? std::string("standard output cannot be written: ") + error.code().message()
                       : std::string("internal error: ") + error.what(),
                  full ? wrong_usage : internal_error);
  } catch (const std::exception& error) {
    return refuse(std::string("internal error: ") + error.what(), internal_error);
  }
}

}  // namespace plumb
