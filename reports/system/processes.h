#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// External programs, found in PATH as a shell finds them. `words` is the program and its arguments.
namespace plumb {

/// The full path of a program in PATH; nullopt if there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs a program and waits for it; its output goes to our own streams. Returns its exit code, 127 if it could not be
/// started, or 128 plus the signal that ended it.
int run_program(const std::vector<std::string>& words);

/// Runs a program and returns its standard output without the last line break; nullopt if it could not be started or
/// did not exit with 0. Its standard error is discarded.
std::optional<std::string> output_of(const std::vector<std::string>& words);

/// Starts a program in a session of its own, without input or output, and does not wait: it may outlive us. Returns
/// whether it started.
bool start_program(const std::vector<std::string>& words);

}  // namespace plumb
