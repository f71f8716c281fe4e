#pragma once

#include <string>

namespace plumb {

/// The name of a metamorphic relation among a run's invariants and metrics is this and its own.
inline const std::string relation_prefix = "relation_";

}  // namespace plumb
