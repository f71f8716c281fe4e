#include "reports/cli/program.h"

#include <fmt/core.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>

#include "reports/cli/command.h"
#include "reports/system/environment.h"
#include "scenarios/catalog.h"
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

int parse_and_run(std::vector<std::string> arguments) {
  check_engines(Catalog<Engine>::all());
  CLI::App app{"Plumb tells whether a 2D physics engine is right.", "plumb"};
  app.set_version_flag("--version", std::string("plumb ") + version());
  app.require_subcommand(1);
  std::map<const CLI::App*, std::function<int()>> actions;
  for (const Command* command : Catalog<Command>::all()) {
    CLI::App* added = app.add_subcommand(command->name, command->about);
    added->footer("Examples:\n" + command->examples);
    actions[added] = command->attach(*added);
  }
  app.footer(
      "Examples:\n  plumb report\n  plumb run bounce --engine impulse\n  plumb list engines\n\n"
      "Exit codes: 0 fine; 1 a run is wrong or failed (run, find --again), two runs diverge (diff), something is not "
      "as accepted "
      "(check), a fault is not caught (prove); 2 bad usage or input; 3 an internal error; 130 interrupted (study, "
      "find).");

  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 expects
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    throw std::invalid_argument(advice(app, error));
  }
  return actions.at(app.get_subcommands().front())();
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
  try {
    return parse_and_run(std::move(arguments));
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "plumb: {}\nSee plumb --help.\n", error.what());
    return wrong_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumb: internal error: {}\n", error.what());
    return internal_error;
  }
}

}  // namespace plumb
