#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/programs/program_engine.h"
#include "reports/cli/command_line.h"
#include "reports/engines/conformance.h"
#include "reports/engines/installed.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb::commands::engine {
namespace {

struct Options {
  std::string prefix;
  std::vector<std::string> names;
  std::string checked;
};

int list(const Options& options) {
  const auto folder = engines_folder(options.prefix);
  fmt::print("engines of npm, in {}\n", printable(folder.string(), std::string::npos));
  for (const PackagedEngine& engine : packaged_engines()) {
    const bool there = std::filesystem::exists(folder / engine.name);
    const bool current = there && command_of_installed(engine.name, folder);
    fmt::print("  {:<10} {:<14} {}\n", engine.name,
               current ? "installed"
               : there ? "out of date"
                       : "not installed",
               engine.about);
  }
  return 0;
}

int add(const Options& options) {
  const auto folder = engines_folder(options.prefix);
  for (const std::string& name : options.names) {
    const bool added = install_engine(name, folder);
    fmt::print("{} {} in {}\n", name, added ? "is installed" : "was already installed",
               printable((folder / name).string(), std::string::npos));
  }
  return 0;
}

int remove(const Options& options) {
  for (const std::string& name : options.names) {
    fmt::print("{} {}\n", name,
               remove_engine(name, engines_folder(options.prefix)) ? "is removed" : "was not installed");
  }
  return 0;
}

// "exec:COMMAND", or the name of an installed engine.
std::string command_of(const Options& options) {
  if (options.checked.starts_with(program_prefix)) return options.checked.substr(program_prefix.size());
  const auto command = command_of_installed(options.checked, engines_folder(options.prefix));
  if (command) return *command;
  throw std::invalid_argument(
      fmt::format("\"{}\" is no engine that plumb engine add installed; write {}COMMAND for a "
                  "program of yours",
                  options.checked, program_prefix));
}

int check(const Options& options) {
  const bool kept = check_conformance(command_of(options), [](const ConformancePoint& point) {
    using Result = ConformancePoint::Result;
    const char* word = point.result == Result::kept ? "ok" : point.result == Result::skipped ? "-" : "BROKEN";
    fmt::print("{:<7} {}: {}\n", word, point.name, point.detail);
    std::fflush(stdout);
  });
  fmt::print("{}\n", kept ? "It speaks plumb-engine 1." : "It doesn't speak plumb-engine 1 yet.");
  return kept ? 0 : 1;
}

int serve_named(const Options& options) {
  const Engine* engine = Catalog<Engine>::find(options.checked);
  if (engine == nullptr || engine->exact) throw std::invalid_argument("no engine \"" + options.checked + "\"");
  return serve(*engine);
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  const auto chosen = std::make_shared<std::function<int(const Options&)>>();
  app.require_subcommand(1);
  const auto add_word = [&](const char* name, const char* about, int (*run)(const Options&)) -> CLI::App& {
    CLI::App& word = *app.add_subcommand(name, about);
    word.add_option("--prefix", options->prefix, "where engines are installed; default: $XDG_DATA_HOME/plumb/engines")
        ->type_name("DIR");
    word.callback([chosen, run] { *chosen = run; });
    return word;
  };
  add_word("list", "Show the engines of npm that can be installed", list);
  const auto add_names = [&](CLI::App& word) {
    word.add_option("names", options->names, "see plumb engine list")->type_name("NAME")->required();
  };
  add_names(add_word("add", "Install engines by npm, in the versions that Plumb knows", add));
  add_names(add_word("remove", "Remove installed engines", remove));
  add_word("check", "Try whether a program speaks plumb-engine 1, and say what to mend", check)
      .add_option("engine", options->checked, "exec:COMMAND, or the name of an installed engine")
      ->type_name("ENGINE")
      ->required();
  add_word("serve", "Speak plumb-engine 1 for an engine of this program, on standard input and output", serve_named)
      .add_option("engine", options->checked, "its name")
      ->type_name("NAME")
      ->required();
  return [options, chosen] { return (*chosen)(*options); };
}

const Catalog<Command>::Entry entry{
    {.name = "engine",
     .about = "Install engines in other languages, and check your own",
     .examples =
         "  plumb engine add rapier box2d3 && plumb run bounce --engine impulse --engine rapier\n"
         "  plumb run bounce --engine \"exec:python3 mine.py\"      a program of yours: reference/programs/README.md\n"
         "  plumb engine check \"exec:python3 mine.py\"             what to mend in it\n",
     .attach = attach}};

}  // namespace
}  // namespace plumb::commands::engine
