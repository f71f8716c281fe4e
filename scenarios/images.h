#pragma once

#include <cstdint>

#include "scenarios/scene/scene.h"

/// Images of a scene: other scenes whose motion follows from its own by a symmetry of mechanics.
namespace plumb {

/// A congruence of the plane: p becomes p with x negated if `mirrored`, then turned counter-clockwise by `angle`, rad,
/// then moved by `shift`, m.
struct Congruence {
  bool mirrored = false;
  double angle = 0;
  Vec shift;

  Vec of_vector(Vec) const;
  Vec of_point(Vec) const;
  /// Of an angle of a body, rad, whose shapes are mirrored in its own frame.
  double of_angle(double) const;
  double of_spin(double spin) const { return mirrored ? -spin : spin; }
  Congruence inverse() const;
};

/// The scene with everything in it, gravity and forces too, mapped so.
Scene mapped(const Scene&, const Congruence&);

/// Every mass multiplied: densities, and with them forces, torques, stiffnesses and dampings. Accelerations stay.
Scene with_masses(const Scene&, double factor);

/// Other units with the same gravity: lengths multiplied by `length`, masses by `mass`, times by sqrt(length).
Scene in_units(const Scene&, double length, double mass);

/// Every velocity with u, m/s, added; what stood still is kinematic and moves at u. The scene must have no damping of
/// velocities and no spring to a point of the world.
Scene boosted(const Scene&, Vec u);

/// Bodies, the shapes of each, joints and forces listed from last to first.
Scene listed_backwards(const Scene&);

/// A scene with a copy of it listed behind and moved by `shift`, m; the bodies of one never touch those of the other.
/// `layers` is the mask of the bits that are left to the scene; the copy uses them `apart` bits higher.
Scene doubled(const Scene&, Vec shift, std::uint32_t layers, int apart);

/// m, half the diagonal around the dynamic bodies' origins plus their largest radius of gyration; 1 if that is 0.
double extent_of(const Scene&);

}  // namespace plumb
