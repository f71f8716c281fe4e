#pragma once

#include "kernels/contact_lanes.h"
#include "simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

using PointLanes = impulse::PointLanes<lane_count>;
using DiscLanes = impulse::DiscLanes<lane_count>;
template <std::size_t points>
using ContactLanes = impulse::ContactLanes<points, lane_count>;
using ContactTable = impulse::ContactTable<lane_count>;

inline Lanes load(const Row<lane_count>& row) { return Lanes::load(row.lane); }
inline void store(const Lanes& lanes, Row<lane_count>& to) { lanes.store(to.lane); }

/// Rows of four numbers of the bodies that contacts name, one for each lane.
struct NamedRows {
  Real* row[lane_count];

  NamedRows(Real* rows, const std::uint32_t* names) {
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) row[lane] = rows + 4 * names[lane];
  }
};

/// The two bodies of each lane's contact seen along its normal and tangent; see ContactFrame (contact_rows.h), which
/// this follows line by line. All of it is inlined: what it holds lives in registers.
struct LanesFrame {
  NamedRows rows_a, rows_b;
  Lanes a[4], b[4];  // velocities: x, y, angular, 0
  Lanes normal_x, normal_y;
  Lanes mass, inertia_a, inertia_b;
  Lanes normal, tangent;          // relative velocity of the centres, m/s
  Lanes wa, wb;                   // rad/s
  Lanes normal_sum, tangent_sum;  // N s given so far

  template <class Contacts>
  LanesFrame(const Contacts& contacts, Real* velocity)
      : LanesFrame(contacts, velocity, load(contacts.normal_x), load(contacts.normal_y)) {}

  template <class Contacts>
  [[gnu::always_inline]] LanesFrame(const Contacts& contacts, Real* velocity, const Lanes& x, const Lanes& y)
      : rows_a(velocity, contacts.a),
        rows_b(velocity, contacts.b),
        normal_x(x),
        normal_y(y),
        mass(load(contacts.mass_a) + load(contacts.mass_b)),
        inertia_a(load(contacts.inertia_a)),
        inertia_b(load(contacts.inertia_b)),
        normal_sum(Lanes::all(0)),
        tangent_sum(Lanes::all(0)) {
    Lanes::gather(rows_a.row, a);
    Lanes::gather(rows_b.row, b);
    const Lanes apart_x = b[0] - a[0];
    const Lanes apart_y = b[1] - a[1];
    normal = normal_x * apart_x + normal_y * apart_y;
    tangent = normal_x * apart_y - normal_y * apart_x;
    wa = a[2];
    wb = b[2];
  }

  [[gnu::always_inline]] Lanes normal_velocity(const PointLanes& p) const {
    return normal + wb * load(p.cross_b) - wa * load(p.cross_a);
  }
  [[gnu::always_inline]] Lanes tangent_velocity(const PointLanes& p) const {
    return tangent + wb * load(p.dot_b) - wa * load(p.dot_a);
  }

  [[gnu::always_inline]] void push_normal(const PointLanes& p, const Lanes& impulse) {
    normal = normal + impulse * mass;
    wa = wa - impulse * inertia_a * load(p.cross_a);
    wb = wb + impulse * inertia_b * load(p.cross_b);
    normal_sum = normal_sum + impulse;
  }
  [[gnu::always_inline]] void push_tangent(const PointLanes& p, const Lanes& impulse) {
    tangent = tangent + impulse * mass;
    wa = wa - impulse * inertia_a * load(p.dot_a);
    wb = wb + impulse * inertia_b * load(p.dot_b);
    tangent_sum = tangent_sum + impulse;
  }
  /// A vector of the contact frame as one of the world.
  Lanes world_x(const Lanes& along_normal, const Lanes& along_tangent) const {
    return along_normal * normal_x - along_tangent * normal_y;
  }
  Lanes world_y(const Lanes& along_normal, const Lanes& along_tangent) const {
    return along_normal * normal_y + along_tangent * normal_x;
  }
  /// An impulse (N s, world frame) through the centres.
  template <class Contacts>
  void push_centres(const Contacts& contacts, const Lanes& x, const Lanes& y) {
    const Lanes mass_a = load(contacts.mass_a);
    const Lanes mass_b = load(contacts.mass_b);
    a[0] = a[0] - mass_a * x;
    a[1] = a[1] - mass_a * y;
    b[0] = b[0] + mass_b * x;
    b[1] = b[1] + mass_b * y;
    normal = normal + mass * (normal_x * x + normal_y * y);
    tangent = tangent + mass * (normal_x * y - normal_y * x);
  }
  template <class Contacts>
  [[gnu::always_inline]] void leave(const Contacts& contacts) {
    const Lanes x = world_x(normal_sum, tangent_sum);
    const Lanes y = world_y(normal_sum, tangent_sum);
    const Lanes mass_a = load(contacts.mass_a);
    const Lanes mass_b = load(contacts.mass_b);
    a[0] = a[0] - mass_a * x;
    a[1] = a[1] - mass_a * y;
    a[2] = wa;
    b[0] = b[0] + mass_b * x;
    b[1] = b[1] + mass_b * y;
    b[2] = wb;
    Lanes::scatter(a, rows_a.row);
    Lanes::scatter(b, rows_b.row);
  }
};

template <class Contacts>
constexpr bool is_discs = false;
template <>
inline constexpr bool is_discs<DiscLanes> = true;

/// Whether pairs of points are solved at once, as a type.
template <bool value>
struct Block {
  constexpr operator bool() const { return value; }
};

/// Calls solve(contacts, Block) for all lanes of a table in order.
template <class Solve>
void for_all_lanes(const ContactTable& table, Solve solve) {
  for (const LanesRun* run = table.runs; run != table.runs_end; ++run) {
    switch (run->kind) {
      case LanesKind::one:
        for (std::uint32_t i = run->begin; i < run->end; ++i) solve(table.one[i], Block<false>());
        break;
      case LanesKind::discs:
        for (std::uint32_t i = run->begin; i < run->end; ++i) solve(table.discs[i], Block<false>());
        break;
      case LanesKind::two:
        for (std::uint32_t i = run->begin; i < run->end; ++i) solve(table.two[i], Block<false>());
        break;
      case LanesKind::block:
        for (std::uint32_t i = run->begin; i < run->end; ++i) solve(table.block[i], Block<true>());
        break;
    }
  }
}

inline std::uint32_t count_points(const ContactLanes<1>&) { return 1; }
inline std::uint32_t count_points(const ContactLanes<2>&) { return 2; }

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
