#include "contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

Real effective_mass(const ContactRow& row, Real arm_a, Real arm_b) {
  const Real inverse = row.mass_a.m + row.mass_b.m + row.mass_a.i * arm_a * arm_a + row.mass_b.i * arm_b * arm_b;
  return inverse > 0 ? 1 / inverse : Real{0};
}

bool solvable(const BodySet& bodies, const Contact& contact) {
  const InverseMass& a = bodies.inverse_mass[contact.body_a];
  const InverseMass& b = bodies.inverse_mass[contact.body_b];
  return contact.count > 0 && a.m + b.m + a.i + b.i > 0;
}

ContactRow make_row(const BodySet& bodies, const std::vector<Contact>& contacts, std::uint32_t index) {
  const Contact& contact = contacts[index];
  ContactRow row;
  row.a = contact.body_a;
  row.b = contact.body_b;
  row.mass_a = bodies.inverse_mass[row.a];
  row.mass_b = bodies.inverse_mass[row.b];
  row.normal = contact.normal;
  row.static_friction = contact.static_friction;
  row.dynamic_friction = contact.dynamic_friction;
  row.restitution = contact.restitution;
  row.count = contact.count;
  row.contact = index;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const ContactPoint& from = contact.points[i];
    RowPoint& to = row.points[i];
    static_cast<PointPlace&>(to) = place_of(contact, i);
    to.normal_mass = effective_mass(row, to.cross_a, to.cross_b);
    to.tangent_mass = effective_mass(row, to.dot_a, to.dot_b);
    to.normal_impulse = from.normal_impulse;
    to.tangent_impulse = from.tangent_impulse;
  }
  return row;
}

void prepare_rows(const BodySet& bodies, const std::vector<Contact>& contacts, std::vector<ContactRow>& rows) {
  rows.clear();
  for (std::uint32_t c = 0; c < contacts.size(); ++c) {
    if (solvable(bodies, contacts[c])) rows.push_back(make_row(bodies, contacts, c));
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
