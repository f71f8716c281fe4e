#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "scenarios/scene/maps.h"
#include "scenarios/scene/scene.h"

/// All operations that depend on the kind of force: maps, reading from and writing to scene files.
namespace plumb {

class BodyNames;
class JsonReader;

/// A mirror also mirrors the frames of bodies.
Force mapped(const Force&, const Congruence&);
Force in_units(const Force&, const Units&);
/// The force with every body's index replaced.
Force renumbered(const Force&, const std::function<std::size_t(std::size_t)>&);

/// Throws std::invalid_argument if it is not a valid force.
Force read_force(const JsonReader&, const BodyNames&);
/// The scene gives the bodies their names.
nlohmann::ordered_json as_json(const Force&, const Scene&);

}  // namespace plumb
