#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>

namespace plumb {

/// A command of plumb. Joins Catalog<Command> from its own file.
struct Command {
  std::string name;
  std::string about;     // one line
  std::string examples;  // shown under --help
  /// Adds the options. The returned function runs after they have been read and returns the exit code.
  std::function<std::function<int()>(CLI::App&)> attach;
};

}  // namespace plumb
