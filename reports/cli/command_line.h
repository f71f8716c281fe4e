#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace plumb {

/// A command of plumb. Joins Catalog<Command> from its own file.
struct Command {
  std::string name;
  std::string about;     // one line
  std::string examples;  // shown under --help
  /// Adds the options. The returned function runs after they have been read and returns the exit code.
  std::function<std::function<int()>(CLI::App&)> attach;
};

/// The program's whole command line: what --help, `plumb help`, the completions and the manual page show.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  CLI::App& app() { return app_; }
  const CLI::App& app() const { return app_; }

  /// Runs the command that was parsed; returns the exit code.
  int run() const;

 private:
  CLI::App app_;
  std::map<const CLI::App*, std::function<int()>> actions_;
};

/// The commands of an app, by name; those that are hidden from --help are left out.
std::vector<const CLI::App*> commands_of(const CLI::App&);

/// An exit code of the program and when it is returned.
struct ExitCode {
  int code;
  const char* about;
};

/// Of the whole program, in order.
const std::vector<ExitCode>& exit_codes();

}  // namespace plumb
