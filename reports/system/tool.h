#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Other people's programs, found as a shell finds them.
namespace plumb {

/// Where a program lies in PATH; nothing where it does not.
std::optional<std::filesystem::path> find_tool(const std::string& name);

/// Runs a program (the first word) and waits for it; what it says goes where our own words go. Its exit code; 127 where
/// it could not be started, 128 and the signal's number where one ended it.
int run_tool(const std::vector<std::string>& words);

/// Starts a program in silence and in a session of its own, and does not wait: it may outlive us. Whether it started.
bool start_tool(const std::vector<std::string>& words);

}  // namespace plumb
