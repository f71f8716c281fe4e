#pragma once

#include <array>
#include <cmath>

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
};

/// Part of it, or, below 0, what takes that back: given as well, but the other way.
inline ContactEffect operator*(Real share, const ContactEffect& of) {
  return {share * of.impulse, std::abs(share) * of.given, share * of.turned_a, share * of.turned_b};
}

/// N s, of each point along normal and tangent, that act on the bodies as all impulses of the step did; `total` is what
/// each point got, along whichever normal it had. If the normal turned meanwhile, the contact gets the mean one, and
/// points where they turn the bodies as much. None if all that is left of opposite impulses is rounding, which has no
/// direction.
std::array<Vec2, 2> reported(const ContactEffect& effect, std::array<Vec2, 2> total, const InverseMass& mass_a,
                             const InverseMass& mass_b, Contact& contact);

}  // namespace impulse::inline IMPULSE_PRECISION
