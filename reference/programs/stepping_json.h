#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenarios/scenario.h"
#include "scenarios/scene/json_reader.h"

/// What an engine that is a program states about its steps, in the words of engine.schema.json.
namespace plumb::protocol {

nlohmann::ordered_json stepping_as_json(const Stepping&);

/// The same back, of steps of dt seconds. Throws std::invalid_argument, naming the place, if anything is unknown or out
/// of range.
Stepping stepping_of(const JsonReader&, double dt);

}  // namespace plumb::protocol
