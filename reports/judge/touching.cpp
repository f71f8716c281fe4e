#include "reports/judge/touching.h"

#include <algorithm>
#include <cmath>

#include "reports/vec.h"

namespace plumb {

bool Touching::acts(double slack) const { return push > 0 || separation() < -slack; }

double Touching::separation() const {
  return std::min_element(points.begin(), points.end(),
                          [](const auto& one, const auto& other) { return one.separation < other.separation; })
      ->separation;
}

TouchingPairs touching_pairs(std::span<const ContactState> contacts) {
  TouchingPairs pairs;
  for (ContactState contact : contacts) {
    if (contact.a > contact.b) {
      // Seen from the other body both impulses and both directions turn round: their products stay.
      std::swap(contact.a, contact.b);
      contact.normal = -1 * contact.normal;
    }
    Touching& touching = pairs[{contact.a, contact.b}];
    touching.push += contact.normal_impulse;
    touching.rub += contact.tangent_impulse;
    touching.points.push_back(contact);
  }
  return pairs;
}

}  // namespace plumb
