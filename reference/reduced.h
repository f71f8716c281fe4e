#pragma once

#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

/// Scenes without what a model leaves out: work that an engine does by body or by material, and only where it is asked
/// for.
namespace plumb {

/// "rotation", "friction" and "restitution".
std::vector<Option> reductions();

/// The scene as those options have it; others are not looked at. The options must be there.
Scene reduced(Scene, const Settings&);

}  // namespace plumb
