#pragma once

#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

/// Models that leave features out. An engine that handles rotation, friction and restitution body by body saves their
/// cost in a scene that has none.
namespace plumb {

/// The options "rotation", "friction" and "restitution".
std::vector<Option> reductions();

/// The scene as those options have it. They must be present in the settings; other options are ignored.
Scene reduced(Scene, const Settings&);

/// The redundant features of a scene: options of our engine and the values that switch a feature off, where the scene
/// alone proves that the true motion does not change, with the proof in words.
std::vector<Choice> redundant_features(const Scene&);

/// Why no two bodies can touch before the scene ends; "" if some pair might, or if there are too many pairs to check.
std::string why_none_meet(const Scene&);

}  // namespace plumb
