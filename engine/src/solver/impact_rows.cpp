#include "solver/impact_rows.h"

#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Whether these are the points that the row was made of: of two discs they never are, whose normal turns with them.
bool keeps_points(const ImpactRow& row, const Contact& contact) {
  const auto same = [](const Pose& then, const Pose& now) { return then.p == now.p && then.q == now.q; };
  return row.made && !contact.discs() && same(row.found_a, contact.found_a) && same(row.found_b, contact.found_b) &&
         row.normal == contact.normal && row.found_separation == contact.found_separation;
}

/// A row whose contact keeps its points: only how deep they are and what they bear is new.
void go_on(ImpactRow& row, const Contact& contact) {
  row.static_friction = contact.static_friction;
  row.dynamic_friction = contact.dynamic_friction;
  row.restitution = contact.restitution;
  row.active = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    RowPoint& p = row.points[i];
    p.separation = contact.points[i].separation;
    p.normal_impulse = contact.points[i].normal_impulse;
    p.tangent_impulse = contact.points[i].tangent_impulse;
    p.total_normal = 0;
    p.total_tangent = 0;
  }
}

/// The normal along which a contact acted in this step. It is no longer the one that its points were found with, from
/// which they could be kept.
void show(Vec2 normal, Contact& contact) {
  contact.normal = normal;
  contact.found_a.p = contact.found_b.p = Vec2{1, 1} * std::numeric_limits<Real>::infinity();
}

}  // namespace

void renew(ImpactRow& row, const BodySet& bodies, const std::vector<Pose>& start, const std::vector<Contact>& contacts,
           std::uint32_t index) {
  const Contact& contact = contacts[index];
  if (keeps_points(row, contact)) {
    go_on(row, contact);
  } else {
    row = {make_row(bodies, contacts, index)};
    row.made = true;
    row.found_a = contact.found_a;
    row.found_b = contact.found_b;
    row.found_separation = contact.found_separation;
  }
  row.stirs_a = bodies.moves(row.a);
  row.stirs_b = bodies.moves(row.b);
  row.disc_distance = contact.discs() ? contact.radius_a + contact.radius_b : Real{0};
  row.turns = contact.discs();
  row.between = start[row.b].p - start[row.a].p;
  row.age = contact.age;
  row.fresh = contact.age == 0;
}

void leave(ImpactRow& row, Real offset_scale, std::vector<Contact>& contacts) {
  Contact& contact = contacts[row.contact];
  contact.offset = row.offset / offset_scale;
  if (row.turns) show(row.join(), contact);
  store_row(row, contacts);
}

}  // namespace impulse::inline IMPULSE_PRECISION
