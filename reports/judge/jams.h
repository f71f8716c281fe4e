#pragma once

#include <vector>

#include "reports/trace.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// m/s, by moment and body, rim included: the changes of velocity in jams, impacts without a collision (Painleve;
/// Lecornu). In a jam touching bodies that nothing approaches change their velocities at once, because friction turns
/// the contact under the body. A step counts if it changes the velocity by more than twice what gravity does, by what
/// neither the step before nor the one after does.
std::vector<std::vector<double>> jams_in(const Scene&, const Trace&);

}  // namespace plumb
