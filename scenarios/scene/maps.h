#pragma once

#include "scenarios/scene/vec.h"

/// Maps of a scene under which its motion follows from its own by a symmetry of mechanics.
namespace plumb {

/// A congruence of the plane: p becomes p with x negated if `mirrored`, then turned counter-clockwise by `angle`, rad,
/// then moved by `shift`, m.
struct Congruence {
  bool mirrored = false;
  double angle = 0;
  Vec shift;

  Vec of_vector(Vec v) const { return rotated({mirrored ? -v.x : v.x, v.y}, angle); }
  Vec of_point(Vec p) const { return of_vector(p) + shift; }
  double of_spin(double spin) const { return mirrored ? -spin : spin; }
  /// Of an angle of a body, rad, whose shapes are mirrored in its own frame.
  double of_angle(double turned) const { return of_spin(turned) + angle; }
  Congruence inverse() const;
};

// Without a mirror the inverse turns back; a mirror M has R(a) M = M R(-a), so that R(a) M is its own inverse.
inline Congruence Congruence::inverse() const {
  Congruence back{.mirrored = mirrored, .angle = mirrored ? angle : -angle, .shift = {}};
  back.shift = -back.of_vector(shift);
  return back;
}

/// A map of a body's frame: p becomes p with x negated if `mirrored`, then multiplied by `factor`, less `origin`.
struct FrameMap {
  bool mirrored = false;
  double factor = 1;
  Vec origin;

  Vec of_direction(Vec v) const { return {mirrored ? -v.x : v.x, v.y}; }
  Vec of_point(Vec p) const { return factor * of_direction(p) - origin; }
  double of_angle(double angle) const { return mirrored ? -angle : angle; }
};

/// Other units: every length is multiplied by `length`, every mass by `mass`, every time by `time`.
struct Units {
  double length = 1, mass = 1, time = 1;

  double speed() const { return length / time; }
  double acceleration() const { return length / (time * time); }
  double force() const { return mass * acceleration(); }
  double torque() const { return force() * length; }
  double stiffness() const { return mass / (time * time); }
  double damping() const { return mass / time; }
};

}  // namespace plumb
