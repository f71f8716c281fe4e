#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Engines of npm, each installed in a folder of its own with the versions and hashes that Plumb's adapter was written
/// for. Once installed, they need no network.
namespace plumb {

struct PackagedEngine {
  std::string name;
  std::string about;  // one line
};

/// Those that can be installed, by name.
std::vector<PackagedEngine> packaged_engines();

/// Where engines are installed: the given folder, or `plumb/engines` in $XDG_DATA_HOME, which is ~/.local/share if it
/// is not set.
std::filesystem::path engines_folder(const std::string& prefix = "");

/// The command that starts an installed engine (see engine_of_program); nullopt if it isn't there, or not as this Plumb
/// would install it.
std::optional<std::string> command_of_installed(const std::string& name, const std::filesystem::path& folder);

/// Installs by npm; returns false if it was there already. A folder appears only when it is complete. Throws
/// std::invalid_argument for an unknown name, if npm or Node.js 18 is missing, and if npm fails.
bool install_engine(const std::string& name, const std::filesystem::path& folder);

/// Returns false if it was not there. Throws std::invalid_argument for an unknown name.
bool remove_engine(const std::string& name, const std::filesystem::path& folder);

}  // namespace plumb
