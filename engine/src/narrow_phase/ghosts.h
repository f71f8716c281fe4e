#pragma once

#include <optional>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Ghost collisions at the joins of the fixed world.
///
/// Where a shape slides over the join of two fixed ones, be they tiles side by side or segments end to end, the one
/// ahead is nearest at its end point or its buried side, with a normal that the joined surface does not have. The face
/// that the shape slides on already keeps it from there: a point at or below that face is reached by nothing that stays
/// above the face. So
///
///   a face that rises from the join is met along its own normal, as a half-space: in a hollow both half-spaces hold
///   everywhere, and this also tells in time how far it is;
///   where nothing rises, there is nothing to meet.
///
/// Known as internal edges (G. van den Bergen, Collision Detection in Interactive 3D Environments, 2003), which are
/// commonly told by adjacency; here none need be known, and the shapes may belong to different bodies.

/// A contact of a dynamic body's part with the fixed world.
struct Meeting {
  const Contact& contact;
  std::uint32_t fixed, dynamic;  // bodies
  const Shape& ground;           // the fixed one's
  const Shape& part;             // the dynamic one's
  Vec2 up;                       // the normal, from ground to part

  Meeting(const Contact& of, const BodySet& bodies, bool dynamic_first);
  bool dynamic_first() const { return contact.body_a == dynamic; }
};

struct Plane {
  Vec2 normal, place;
  Real height(Vec2 p) const { return dot(normal, p - place); }
};

/// The face of the ground that the contact is on; none if it is on a corner.
std::optional<Plane> face_under(const Meeting& meeting, const BodySet& bodies);

/// What takes the place of a contact while `plane` keeps the part from below it: no points, where the contact is a
/// ghost. None where it must stay as it is.
std::optional<Manifold> without_ghost(const Meeting& meeting, const Plane& plane, const BodySet& bodies,
                                      const Margin& margin);

}  // namespace impulse::inline IMPULSE_PRECISION
