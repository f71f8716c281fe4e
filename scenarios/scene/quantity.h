#pragma once

namespace plumb {

/// What can be read off a motion. x, y, vx and vy are of the centre of mass. Energy (kinetic + gravity + springs and
/// attractions) and momenta (angular momentum about the world's origin) are of the whole scene, over its dynamic
/// bodies. The quantities from `load` on belong to a run rather than to a moment.
enum class Quantity {
  x,
  y,
  angle,
  vx,
  vy,
  speed,
  angular_velocity,
  energy,
  momentum_x,
  momentum_y,
  angular_momentum,
  speed_spread,  // <v^4>/<v^2>^2 over the dynamic bodies: 1 if all are equally fast, 2 for the 2D Maxwell distribution
  load,          // sum of the normal forces of a body's contacts
  energy_rise,   // largest increase of the energy over its value at any earlier moment
  landing,       // time of a local minimum of y
  apex           // a local maximum of y
};

const char* name_of(Quantity);
const char* unit_of(Quantity);

/// Whether a quantity belongs to the whole scene rather than to a body.
bool of_whole_scene(Quantity);

/// How the measured value must compare with the expected one, within the tolerance.
enum class Relation { equal, at_least, at_most };

/// "equal", "at least", "at most".
const char* name_of(Relation);

}  // namespace plumb
