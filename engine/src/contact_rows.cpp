#include "contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

Real effective_mass(const ContactRow& row, Real arm_a, Real arm_b) {
  const Real inverse = row.mass_a.m + row.mass_b.m + row.mass_a.i * arm_a * arm_a + row.mass_b.i * arm_b * arm_b;
  return inverse > 0 ? 1 / inverse : Real{0};
}

void prepare_rows(const BodySet& bodies, const std::vector<Contact>& contacts, std::vector<ContactRow>& rows) {
  rows.clear();
  for (std::uint32_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    ContactRow row;
    row.a = contact.body_a;
    row.b = contact.body_b;
    row.mass_a = bodies.inverse_mass[row.a];
    row.mass_b = bodies.inverse_mass[row.b];
    if (contact.count == 0 || row.mass_a.m + row.mass_b.m + row.mass_a.i + row.mass_b.i == 0) continue;
    row.normal = contact.normal;
    row.static_friction = contact.static_friction;
    row.dynamic_friction = contact.dynamic_friction;
    row.restitution = contact.restitution;
    row.count = contact.count;
    row.contact = c;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const ContactPoint& from = contact.points[i];
      RowPoint& to = row.points[i];
      to.cross_a = cross(from.arm_a, row.normal);
      to.cross_b = cross(from.arm_b, row.normal);
      // The point lay midway when it was found; each arm ends on its own body's surface.
      to.dot_a = dot(from.arm_a, row.normal) - contact.found_separation[i] / 2;
      to.dot_b = dot(from.arm_b, row.normal) + contact.found_separation[i] / 2;
      to.turn_a = to.dot_a - contact.radius_a;
      to.turn_b = to.dot_b + contact.radius_b;
      to.separation = from.separation;
      to.normal_mass = effective_mass(row, to.cross_a, to.cross_b);
      to.tangent_mass = effective_mass(row, to.dot_a, to.dot_b);
      to.normal_impulse = from.normal_impulse;
      to.tangent_impulse = from.tangent_impulse;
    }
    rows.push_back(row);
  }
}

void store_row(const ContactRow& row, std::vector<Contact>& contacts) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& from = row.points[i];
    ContactPoint& to = contacts[row.contact].points[i];
    to.normal_impulse = from.normal_impulse;
    to.tangent_impulse = from.tangent_impulse;
    to.total_normal_impulse = from.total_normal;
    to.total_tangent_impulse = from.total_tangent;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
