#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "reference/simulation.h"
#include "reports/cli/command_line.h"
#include "reports/cli/descriptions.h"
#include "reports/engines/installed.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

namespace plumb::commands::completion {
namespace {

std::vector<std::string> scenarios() {
  std::vector<std::string> names;
  for (const Scenario* one : Catalog<Scenario>::all()) names.push_back(one->name);
  return names;
}

std::vector<std::string> engines_of_npm() {
  std::vector<std::string> names;
  for (const PackagedEngine& one : packaged_engines()) names.push_back(one.name);
  return names;
}

std::vector<std::string> engines() {
  std::vector<std::string> names;
  for (const Engine* one : Catalog<Engine>::all()) {
    if (!one->exact) names.push_back(one->name);
  }
  std::ranges::move(engines_of_npm(), std::back_inserter(names));
  return names;
}

// What plumb help explains and one word of a shell can be.
std::vector<std::string> help_words(const CommandLine& line) {
  std::vector<std::string> names;
  for (const CLI::App* one : commands_of(line.app())) names.push_back(one->get_name());
  for (const Topic& one : topics()) {
    if (one.name.find_first_of(" /") == std::string::npos) names.push_back(one.name);
  }
  return names;
}

// The subcommands and options that may follow a command, and the names that its own words may be.
std::string words_after(const CLI::App& command, const CommandLine& line) {
  std::vector<std::string> words;
  for (const CLI::App* one : commands_of(command)) words.push_back(one->get_name());
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  const auto takes = [&](const std::string& positional) {
    return command.get_option_no_throw(positional) != nullptr &&
           command.get_option_no_throw(positional)->get_positional();
  };
  std::vector<std::string> names;
  if (takes("scenario") || command.get_name() == "show") names = scenarios();
  if (takes("first") || command.get_name() == "show") std::ranges::move(engines(), std::back_inserter(names));
  if (takes("engine")) std::ranges::move(engines(), std::back_inserter(names));
  if (takes("names")) std::ranges::move(engines_of_npm(), std::back_inserter(names));
  if (command.get_name() == "help") names = help_words(line);
  if (command.get_name() == "completion") names = {"bash", "zsh"};
  std::ranges::move(names, std::back_inserter(words));
  return fmt::format("{}", fmt::join(words, " "));
}

// A branch of `case $at in` for a command and for each of its own.
std::string branches_of(const CLI::App& command, const std::string& path, const CommandLine& line) {
  std::string text = fmt::format("    '{}') words='{}' ;;\n", path, words_after(command, line));
  for (const CLI::App* one : commands_of(command)) text += branches_of(*one, path + " " + one->get_name(), line);
  return text;
}

std::string script() {
  const CommandLine line;
  std::string commands;
  std::vector<std::string> with_subcommands;
  for (const CLI::App* one : commands_of(line.app())) {
    commands += branches_of(*one, one->get_name(), line);
    if (!commands_of(*one).empty()) with_subcommands.push_back(one->get_name());
  }
  return fmt::format(R"(_plumb() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} at=${{COMP_WORDS[1]}} words=
  if [ "$COMP_CWORD" = 1 ]; then at=; fi
  case $at in
    {}) if [ "$COMP_CWORD" -gt 2 ]; then at="$at ${{COMP_WORDS[2]}}"; fi ;;
  esac
  case $at in
    '') words='{}' ;;
{}  esac
  case $before in
    --engine|--statement|--time-engine) words='{}' ;;
    --scenario|--scenarios|--preview) words='{}' ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  if [ ${{#COMPREPLY[@]}} = 0 ]; then COMPREPLY=($(compgen -f -- "$word")); fi
}}
complete -o filenames -F _plumb plumb ./plumb
)",
                     fmt::join(with_subcommands, "|"), words_after(line.app(), line), commands,
                     fmt::join(engines(), " "), fmt::join(scenarios(), " "));
}

int print_script(const std::string& shell) {
  const std::vector<std::string> shells{"bash", "zsh"};
  if (std::ranges::find(shells, shell) == shells.end()) throw std::invalid_argument(unknown("shell", shell, shells));
  if (shell == "zsh") fmt::print("#compdef plumb\nautoload -U +X bashcompinit && bashcompinit\n");
  fmt::print("{}", script());
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "completion",
     .about = "Print a script that completes commands, options, scenarios and engines in a shell",
     .examples = "  source <(plumb completion bash)      in ~/.bashrc\n"
                 "  source <(plumb completion zsh)       in ~/.zshrc, after compinit\n",
     .attach = [](CLI::App& app) {
       const auto shell = std::make_shared<std::string>();
       app.add_option("shell", *shell, "bash or zsh")->required()->type_name("SHELL");
       return [shell] { return print_script(*shell); };
     }}};

}  // namespace
}  // namespace plumb::commands::completion
