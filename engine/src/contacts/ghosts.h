#pragma once

#include <cstdint>
#include <optional>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "narrow_phase/collide.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Ghost collisions at the joins of the fixed world, or of kinematic bodies that move as one.
///
/// When a shape slides over the join of two fixed shapes, tiles side by side or segments end to end, the one ahead is
/// nearest at its end point or its buried side, with a normal that the joined surface does not have. But the face that
/// the shape slides on already keeps it away from there: nothing that stays above that face can reach a point at or
/// below it. So
///
///   a face that rises from the join collides along its own normal, as a half-space: in a hollow both half-spaces hold
///   everywhere, and its distance is known in time;
///   if no face rises, there is no contact.
///
/// Known as internal edges (G. van den Bergen, Collision Detection in Interactive 3D Environments, 2003), which are
/// usually found by adjacency. This method needs none, and the shapes may belong to different bodies.

/// A contact of a dynamic body's part with a body that cannot be pushed.
struct GroundContact {
  const Contact& contact;
  std::uint32_t fixed, dynamic;  // bodies
  const Shape& ground;           // of the fixed body
  const Shape& part;             // of the dynamic body
  Vec2 up;                       // the normal, from ground to part

  GroundContact(const Contact& of, const BodySet& bodies, bool dynamic_first);
  bool dynamic_first() const { return contact.body_a == dynamic; }
};

struct Plane {
  Vec2 normal, place;
  Real height(Vec2 p) const { return dot(normal, p - place); }
};

/// Whether two bodies that cannot be pushed keep their places relative to each other, up to rounding.
bool joined(const BodySet& bodies, std::uint32_t a, std::uint32_t b);

/// Whether the part is in a corner of two pieces of ground, of which the faces go on in front of each other: it slides
/// from neither to the other.
bool form_corner(const GroundContact& one, const GroundContact& other, const BodySet& bodies);

struct Placed {
  const Shape& shape;
  const Pose& pose;
};

/// The manifold of a part with the whole plane of the ground's face of this normal; nullopt if it has no such face. In
/// a corner of the ground the part cannot pass that face's end, behind which its own faces would meet it. `margin`: m.
std::optional<Manifold> on_face(const Placed& ground, Vec2 up, const Placed& part, Real margin);

/// The face of the ground that the contact lies on; nullopt if it is at a corner.
std::optional<Plane> face_under(const GroundContact& at, const BodySet& bodies);

/// Replaces a contact while `plane` keeps the part above it: by a manifold without points if the contact is a ghost.
/// Returns nullopt if the contact is no ghost and must stay.
std::optional<Manifold> without_ghost(const GroundContact& at, const Plane& plane, const BodySet& bodies,
                                      const Margin& margin);

}  // namespace impulse::inline IMPULSE_PRECISION
