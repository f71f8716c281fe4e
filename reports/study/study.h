#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plumb {

struct StudyPlan;

/// Many runs that answer one question together. Each study joins Catalog<Study> from its own file in
/// reports/study/<name>/.
struct Study {
  std::string name;
  std::string about;     // one line
  std::string examples;  // shown under --help
  /// Adds the study's options and returns a function that, once they are parsed, gives the configuration: everything
  /// that the results depend on. Results of different configurations are never mixed. Both throw std::invalid_argument
  /// for mistakes of the user.
  std::function<std::function<nlohmann::ordered_json()>(CLI::App&)> attach;
  /// Returns the same plan for the same configuration on every machine.
  std::function<StudyPlan(const nlohmann::ordered_json& configuration)> plan;
  /// Options of the summary, the short form of the study shown in a report of these engines, every one if there are
  /// none; nullopt if such a report leaves the study out. Null: every report does.
  std::function<std::optional<std::vector<std::string>>(const std::vector<std::string>& engines)> summary = nullptr;
};

/// Options followed by --engine for each of the engines.
std::vector<std::string> with_engines(std::vector<std::string> options, const std::vector<std::string>& engines);

}  // namespace plumb
