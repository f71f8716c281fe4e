#pragma once

#include <optional>
#include <string>

#include "reports/run/run.h"

/// What an iterative solver leaves unsolved is cured by more iterations; nothing else is.
namespace plumb {

/// How many times the iterations of a run a second one gets.
inline constexpr int more_times = 32;

/// An engine with more iterations.
struct MoreIterations {
  EngineConfig config;
  std::string before, after;  // the counts: "8/3", "256/96"
};

/// The options that the engine's own statement calls iterations: those that change the counts it states, and neither
/// its step nor its sub-step. They are multiplied by `more_times`, at most to their maximum. nullopt if there is none.
std::optional<MoreIterations> with_more_iterations(const EngineConfig&, double dt);

}  // namespace plumb
