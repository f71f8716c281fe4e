#include "solver/lanes/contact_frame.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

const ContactPoint& point_of(const Contact& contact, std::uint32_t i) {
  return reinterpret_cast<const ContactPoint*>(&contact.points)[i];
}

void fetch(const Contact* contacts, const Slot& slot) {
  if (slot.tie.contact == Slot::empty) return;
  constexpr std::uint32_t cache_line = 64;
  const char* begin = reinterpret_cast<const char*>(contacts + slot.tie.contact);
  for (std::uint32_t i = 0; i < sizeof(Contact); i += cache_line) __builtin_prefetch(begin + i);
}

/// Gathers four columns from the rows row_of(lane).
template <class RowOf>
[[gnu::always_inline]] inline void gather(Lanes columns[4], RowOf row_of) {
  struct Rows {
    RowOf row_of;
    const Real* operator[](std::uint32_t lane) const { return row_of(lane); }
  };
  Lanes::gather(Rows{row_of}, columns);
}

Lanes inverse(const Lanes& effective) {
  const Lanes nothing = Lanes::all(0);
  return select(nothing < effective, Lanes::all(1) / effective, nothing);
}

/// The data of a point that every kind of contact needs.
template <class Contacts>
void lay_out_point(const Contact* const* contact, std::uint32_t i, const Lanes& share, const Lanes& mass,
                   Contacts& lanes) {
  auto& to = lanes.point[i];
  for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
    to.separation.lane[lane] = point_of(*contact[lane], i).separation;
  }
  const Lanes separation = load(to.separation) - load(lanes.offset);
  store(separation, to.separation);
  store(separation, to.gap);

  Lanes impulses[4];
  gather(impulses, [&](std::uint32_t lane) { return &point_of(*contact[lane], i).normal_impulse; });
  store(impulses[0] * share, to.normal_impulse);
  if constexpr (rubs<Contacts>) {
    store(impulses[1] * share, to.tangent_impulse);
  } else {
    store(inverse(mass), to.normal_mass);
  }
}

/// arms_of() and effective_mass() (contact_rows.h) in lanes.
template <class Contacts>
void place_point(const Contact* const* contact, std::uint32_t i, const Lanes& normal_x, const Lanes& normal_y,
                 const Lanes& found_separation, const Lanes& mass, Contacts& lanes) {
  PointLanes& to = lanes.point[i];
  Lanes arms[4];
  gather(arms, [&](std::uint32_t lane) { return &point_of(*contact[lane], i).arm_a.x; });
  const Lanes cross_a = arms[0] * normal_y - arms[1] * normal_x;
  const Lanes cross_b = arms[2] * normal_y - arms[3] * normal_x;
  const Lanes half_gap = found_separation / Lanes::all(2);
  const Lanes dot_a = arms[0] * normal_x + arms[1] * normal_y - half_gap;
  const Lanes dot_b = arms[2] * normal_x + arms[3] * normal_y + half_gap;
  store(cross_a, to.cross_a);
  store(cross_b, to.cross_b);
  store(dot_a, to.dot_a);
  store(dot_b, to.dot_b);

  const Lanes inertia_a = load(lanes.inertia_a);
  const Lanes inertia_b = load(lanes.inertia_b);
  store(inverse(mass + inertia_a * cross_a * cross_a + inertia_b * cross_b * cross_b), to.normal_mass);
  store(inverse(mass + inertia_a * dot_a * dot_a + inertia_b * dot_b * dot_b), to.tangent_mass);
}

template <class Contacts>
void lay_out(const LayoutInput& input, const Slot* slots, Contacts& lanes) {
  const Contact* contact[lane_count];
  Real masses[lane_count];
  std::uint32_t web = 0;
  std::uint32_t fixed = 0;
  std::uint32_t aged = 0;
  std::uint32_t fresh = 0;
  std::uint32_t slips = 0;
  for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
    const Slot& slot = slots[lane];
    const bool present = slot.tie.contact != Slot::empty;
    contact[lane] = present ? input.contacts + slot.tie.contact : input.no_contact;
    lanes.a[lane] = 4 * (present ? input.row_of[slot.tie.a] : input.nobody);
    lanes.b[lane] = 4 * (present ? input.row_of[slot.tie.b] : input.nobody);
    const InverseMass mass_a = present ? input.masses[slot.tie.a] : InverseMass{};
    const InverseMass mass_b = present ? input.masses[slot.tie.b] : InverseMass{};
    masses[lane] = mass_a.m + mass_b.m;
    const auto bit_where = [lane](bool holds) { return (holds ? 1U : 0U) << lane; };
    web |= bit_where(slot.web);
    fixed |= bit_where(mass_a.m == 0 || mass_b.m == 0);
    lanes.offset.lane[lane] = contact[lane]->offset;
    const int age = contact[lane]->age;
    aged |= bit_where(present && age >= input.offset_from_age);
    fresh |= bit_where(present && age == 0);
    slips |= bit_where(contact[lane]->slips);
    if constexpr (rubs<Contacts>) {
      lanes.inertia_a.lane[lane] = mass_a.i;
      lanes.inertia_b.lane[lane] = mass_b.i;
    }
  }
  lanes.web = web;
  lanes.fixed = fixed;
  lanes.aged = aged;
  lanes.fresh = fresh;
  Lanes head[4];
  gather(head, [&](std::uint32_t lane) { return &contact[lane]->normal.x; });
  store(head[0], lanes.normal_x);
  store(head[1], lanes.normal_y);
  Lanes surface[4];
  gather(surface, [&](std::uint32_t lane) { return &contact[lane]->static_friction; });
  if constexpr (rubs<Contacts>) {
    store(surface[0], lanes.static_friction);
    store(surface[1], lanes.dynamic_friction);
    lanes.two_frictions = (~(surface[0] == surface[1]).bits()) & all_lanes;
    lanes.slips = slips;
    store(select(Lanes::Mask::of(slips), surface[1], surface[0]), lanes.friction);
    store(surface[2], lanes.radius_a);
    store(surface[3], lanes.radius_b);
    lanes.rounded = (Lanes::all(0) < surface[2] + surface[3]).bits() != 0;
  }
  if constexpr (is_discs<Contacts>) {
    Lanes a[4];
    Lanes b[4];
    gather(a, [&](std::uint32_t lane) { return &input.poses[contact[lane]->body_a].p.x; });
    gather(b, [&](std::uint32_t lane) { return &input.poses[contact[lane]->body_b].p.x; });
    store(b[0] - a[0], lanes.between_x);
    store(b[1] - a[1], lanes.between_y);
    store(surface[2] + surface[3], lanes.distance);
  }
  const Lanes share = Lanes::all(1 / input.substeps);
  const Lanes mass = Lanes::load(masses);
  for (std::uint32_t i = 0; i < count_points(lanes); ++i) {
    lay_out_point(contact, i, share, mass, lanes);
    if constexpr (rubs<Contacts>) {
      place_point(contact, i, head[0], head[1], head[2 + i], mass, lanes);
    }
  }
}

template <class Contacts>
void lay_out_all(const LayoutInput& input, LanesKind kind, Contacts* all) {
  const Slot* slots = input.slots[static_cast<std::uint32_t>(kind)];
  const std::uint32_t groups = input.groups[static_cast<std::uint32_t>(kind)];
  for (std::uint32_t group = 0; group < groups; ++group, slots += lane_count) {
    if (group + 1 < groups) {
      for (std::uint32_t lane = 0; lane < lane_count; ++lane) fetch(input.contacts, slots[lane_count + lane]);
    }
    lay_out(input, slots, all[group]);
  }
}

template <class Contacts>
void store_all(const LayoutInput& input, LanesKind kind, const Contacts* all) {
  const Slot* slots = input.slots[static_cast<std::uint32_t>(kind)];
  const std::uint32_t groups = input.groups[static_cast<std::uint32_t>(kind)];
  const Lanes substeps = Lanes::all(input.substeps);
  for (std::uint32_t group = 0; group < groups; ++group, slots += lane_count) {
    const Contacts& lanes = all[group];
    if (group + 1 < groups) {
      for (std::uint32_t lane = 0; lane < lane_count; ++lane) fetch(input.contacts, slots[lane_count + lane]);
    }
    for (std::uint32_t i = 0; i < count_points(lanes); ++i) {
      const auto& p = lanes.point[i];
      Lanes impulses[4] = {load(p.normal_impulse) * substeps, Lanes::all(0), load(p.total_normal), Lanes::all(0)};
      if constexpr (rubs<Contacts>) {
        impulses[1] = load(p.tangent_impulse) * substeps;
        impulses[3] = load(p.total_tangent);
      }
      Real unread[4];
      Real* rows[lane_count];
      for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
        const std::uint32_t contact = slots[lane].tie.contact;
        rows[lane] = contact == Slot::empty
                         ? unread
                         : &reinterpret_cast<ContactPoint*>(&input.contacts[contact].points)[i].normal_impulse;
      }
      Lanes::scatter(impulses, rows);
    }
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const std::uint32_t contact = slots[lane].tie.contact;
      if (contact == Slot::empty) continue;
      input.contacts[contact].offset = lanes.offset.lane[lane];
      if constexpr (rubs<Contacts>) input.contacts[contact].slips = (lanes.slips >> lane & 1U) != 0;
    }
  }
}

}  // namespace

void lay_out_contacts(const ContactTable& table, const LayoutInput& input) {
  lay_out_all(input, LanesKind::one, table.one);
  lay_out_all(input, LanesKind::discs, table.discs);
  lay_out_all(input, LanesKind::two, table.two);
  lay_out_all(input, LanesKind::block, table.block);
  lay_out_all(input, LanesKind::smooth, table.smooth);
  lay_out_all(input, LanesKind::smooth_discs, table.smooth_discs);
}

void store_contacts(const ContactTable& table, const LayoutInput& input) {
  store_all(input, LanesKind::one, table.one);
  store_all(input, LanesKind::discs, table.discs);
  store_all(input, LanesKind::two, table.two);
  store_all(input, LanesKind::block, table.block);
  store_all(input, LanesKind::smooth, table.smooth);
  store_all(input, LanesKind::smooth_discs, table.smooth_discs);
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
