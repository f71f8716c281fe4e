#pragma once

#include <optional>

#include "scenarios/scene/scene.h"

/// What the adapters of both versions of Box2D share. Its names are the same in both, its types are not.
namespace plumb {

/// Fills in a motor of a joint definition; `most` is its maxMotorTorque, N m, or maxMotorForce, N.
template <class Def>
void set_motor(Def& def, float& most, const std::optional<Motor>& motor) {
  if (!motor) return;
  def.enableMotor = true;
  def.motorSpeed = static_cast<float>(motor->speed);
  most = static_cast<float>(motor->strength);
}

/// Fills in the limits of a joint definition: `low` and `high` are its lowerAngle and upperAngle, rad, or its
/// lowerTranslation and upperTranslation, m.
template <class Def>
void set_limits(Def& def, float& low, float& high, const std::optional<Limits>& limits) {
  if (!limits) return;
  def.enableLimit = true;
  low = static_cast<float>(limits->low);
  high = static_cast<float>(limits->high);
}

}  // namespace plumb
