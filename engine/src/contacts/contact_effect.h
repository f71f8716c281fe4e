#pragma once

#include <array>

#include "contacts/contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a contact has done to its bodies in a step, for methods whose normals and arms change within one.
struct ContactEffect {
  Vec2 impulse;                     // N s, on body b, in the world's frame
  Real given = 0;                   // N s, the same, added up without directions
  Real turned_a = 0, turned_b = 0;  // N m s, the moments of these about the bodies' centres

  /// Adds an impulse j, N s, which acted at one point along the normal n and its tangent.
  void note(const PointArms& at, Vec2 n, Vec2 j);
  ContactEffect& operator+=(const ContactEffect& more);
  /// What takes it back: given as well, but the other way.
  ContactEffect operator-() const { return {-impulse, given, -turned_a, -turned_b}; }
};

/// N s, of each point along normal and tangent, that act on the bodies as all impulses of the step did; `total` is what
/// each point got, along whichever normal it had. If the normal turned meanwhile, the contact gets the mean one, and
/// points where they turn the bodies as much. None if all that is left of opposite impulses is rounding, which has no
/// direction.
std::array<Vec2, 2> reported(const ContactEffect& effect, std::array<Vec2, 2> total, const InverseMass& mass_a,
                             const InverseMass& mass_b, Contact& contact);

}  // namespace impulse::inline IMPULSE_PRECISION
