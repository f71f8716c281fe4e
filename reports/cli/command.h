#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>

namespace plumb {

/// A word that plumb understands.
struct Command {
  std::string name;
  std::string about;     // one line
  std::string examples;  // shown under --help
  /// Adds its options; what is returned does the work after they are read, and gives the exit code.
  std::function<std::function<int()>(CLI::App&)> attach;
};

}  // namespace plumb
