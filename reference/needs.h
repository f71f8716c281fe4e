#pragma once

#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// What an engine may leave out of this scene for as long as it lasts: the scene alone proves of each that the right
/// motion does without, and how. Options and values are those of our engine.
std::vector<Choice> needless(const Scene&);

}  // namespace plumb
