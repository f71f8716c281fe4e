#pragma once

#include <optional>
#include <string>

#include "reports/run/run.h"

/// What an engine states about how it steps, and which of its options that makes its iterations.
namespace plumb {

/// What an engine states about how it steps, in words, as far as it concerns what one sees: how far contacts rest from
/// touching, which impacts do not bounce, how often it iterates. "first order; overlaps of up to 5 mm are left alone".
std::string statement(const Stepping&);

// What an iterative solver leaves unsolved is cured by more iterations; nothing else is.

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
