#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "reports/run/run.h"

/// The methods that a study's options select, and what identifies its scenes and jobs.
namespace plumb {

struct Job;

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
