#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/run/run.h"

namespace CLI {
class App;
}

/// A study, the methods that its options select, and what identifies its scenes and jobs.
namespace plumb {

struct Job;
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

/// An engine with a method, and the option that makes it work harder.
struct Method {
  EngineConfig config;
  WorkLadder ladder;  // its option is "" if there is none
};

/// Every method of every engine, Plumb's own engine first. An engine that lists no methods has its default and the
/// configurations that reports show with it.
std::vector<Method> default_methods();

/// The method that each word names ("NAME", or "NAME:key=value,..."). It has the ladder of its method if there is one
/// and the word does not set that option. Without words: all methods. Throws std::invalid_argument for an unknown word,
/// naming the nearest known one.
std::vector<Method> select_methods(const std::vector<std::string>& words);

/// "ENGINE" or "ENGINE:method", from a job's values "engine" and "method".
std::string engine_label(const nlohmann::ordered_json& values);

/// A hash that changes when a scene of a case changes.
std::string hash_of(const std::vector<Case>&);

/// Throws std::invalid_argument, naming it, if a key occurs twice.
void require_distinct_keys(std::span<const Job>);

}  // namespace plumb
