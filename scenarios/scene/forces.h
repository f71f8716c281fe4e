#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenarios/scene/scene.h"

/// All operations that depend on the kind of force: scaling, reading from and writing to scene files.
namespace plumb {

class BodyNames;
class JsonReader;

/// The force in a scene whose lengths are all multiplied by `factor` while masses and times stay the same:
/// accelerations and forces grow like lengths, torques like their square; N/m and N s/m stay.
Force scaled(const Force&, double factor);

/// Throws std::invalid_argument if it is not a valid force.
Force read_force(const JsonReader&, const BodyNames&);
/// The scene gives the bodies their names.
nlohmann::ordered_json as_json(const Force&, const Scene&);

}  // namespace plumb
