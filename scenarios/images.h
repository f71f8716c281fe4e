#pragma once

#include <cstdint>

#include "scenarios/scene/maps.h"
#include "scenarios/scene/scene.h"

/// Scenes derived from another: images, whose motion follows from its own by a symmetry of mechanics, and neighbours.
namespace plumb {

/// The scene with everything in it, gravity and forces too, mapped so.
Scene mapped(const Scene&, const Congruence&);

/// The scene in other units, with the same numbers for angles, friction and restitution. The motion is the same in
/// these units, except for an engine's own lengths and speeds (slops, skins, thresholds).
Scene in_units(const Scene&, const Units&);

/// Every velocity with u, m/s, added; what stood still is kinematic and moves at u. The scene must have no damping of
/// velocities and no spring to a point of the world.
Scene boosted(const Scene&, Vec u);

/// Bodies, the shapes of each, joints and forces listed from last to first.
Scene listed_backwards(const Scene&);

/// A scene with a copy of it listed behind and moved by `shift`, m; the bodies of one never touch those of the other.
/// `layers` is the mask of the bits that are left to the scene; the copy uses them `apart` bits higher.
Scene doubled(const Scene&, Vec shift, std::uint32_t layers, int apart);

/// The same scene with every dynamic body displaced at random by up to `size`, m, along each axis. The same seed gives
/// the same displacements.
Scene perturbed(const Scene&, double size, std::uint64_t seed);

/// m, half the diagonal around the dynamic bodies' origins plus their largest radius of gyration; 1 if that is 0.
double extent_of(const Scene&);

}  // namespace plumb
