#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenarios/scene/scene.h"

/// All operations that depend on the kind of joint: scaling, reading from and writing to scene files.
namespace plumb {

class BodyNames;
class JsonReader;

/// The joint with every length multiplied by `factor`.
Joint scaled(const Joint&, double factor);

/// The joint's limits and motor; null where it has none.
const Limits* limits_of(const Joint&);
const Motor* motor_of(const Joint&);

/// Throws std::invalid_argument if it is not a valid joint.
Joint read_joint(const JsonReader&, const BodyNames&);
/// The scene gives the bodies their names.
nlohmann::ordered_json as_json(const Joint&, const Scene&);

}  // namespace plumb
