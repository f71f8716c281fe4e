#include "contacts/contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

RowPoint point_of(const Contact& contact, std::size_t i, const InverseMass& a, const InverseMass& b) {
  const PointArms arms = arms_of(contact, i);
  return {arms,
          effective_mass(a, b, arms.cross_a, arms.cross_b),
          effective_mass(a, b, arms.dot_a, arms.dot_b),
          contact.points[i].normal_impulse,
          contact.points[i].tangent_impulse,
          0,
          0};
}

}  // namespace

Real effective_mass(const InverseMass& a, const InverseMass& b, Real arm_a, Real arm_b) {
  const Real inverse = a.m + b.m + a.i * arm_a * arm_a + b.i * arm_b * arm_b;
  return inverse > 0 ? 1 / inverse : Real{0};
}

bool solvable(const BodySet& bodies, const Contact& contact) {
  const InverseMass& a = bodies.inverse_mass[contact.body_a];
  const InverseMass& b = bodies.inverse_mass[contact.body_b];
  return contact.count > 0 && a.m + b.m + a.i + b.i > 0;
}

// Built in one expression: clearing rows first would cost twice as much.
ContactRow make_row(const BodySet& bodies, const std::vector<Contact>& contacts, std::uint32_t index) {
  const Contact& contact = contacts[index];
  const InverseMass& mass_a = bodies.inverse_mass[contact.body_a];
  const InverseMass& mass_b = bodies.inverse_mass[contact.body_b];
  const auto point = [&](int i) {
    return i < contact.count ? point_of(contact, static_cast<std::size_t>(i), mass_a, mass_b) : RowPoint{};
  };
  return {contact.body_a,          contact.body_b,           contact.normal,      mass_a,        mass_b,
          contact.static_friction, contact.dynamic_friction, contact.restitution, contact.count, index,
          {point(0), point(1)}};
}

void prepare_rows(const BodySet& bodies, const std::vector<Contact>& contacts, std::vector<ContactRow>& rows) {
  rows.clear();
  for (std::uint32_t c = 0; c < contacts.size(); ++c) {
    if (solvable(bodies, contacts[c])) rows.push_back(make_row(bodies, contacts, c));
  }
}

void store_row(const ContactRow& row, std::vector<Contact>& contacts) {
  Contact& contact = contacts[row.contact];
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.count); ++i) {
    const RowPoint& from = row.points[i];
    ContactPoint& to = contact.points[i];
    to.normal_impulse = from.normal_impulse;
    to.tangent_impulse = from.tangent_impulse;
    to.total_normal_impulse = from.total_normal;
    to.total_tangent_impulse = from.total_tangent;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
