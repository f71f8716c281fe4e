#pragma once

#include <type_traits>

#include "core/simd.h"
#include "solver/lanes/contact_lanes.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

using SmoothPointLanes = impulse::SmoothPointLanes<lane_count>;
using PointLanes = impulse::PointLanes<lane_count>;
using SmoothLanes = impulse::SmoothLanes<lane_count>;
template <std::size_t points>
using ContactLanes = impulse::ContactLanes<points, lane_count>;
using ContactTable = impulse::ContactTable<lane_count>;

inline Lanes load(const Row<lane_count>& row) { return Lanes::load(row.lane); }
inline void store(const Lanes& lanes, Row<lane_count>& to) { lanes.store(to.lane); }

/// The rows of four numbers of the bodies of each lane's contact. Computed one by one: compilers would vectorise an
/// array of pointers, and extracting them from registers again takes longer.
struct NamedRows {
  Real* rows;
  const std::uint32_t* names;

  Real* operator[](std::uint32_t lane) const { return rows + names[lane]; }
};

/// The velocities of the two centres of each lane's contact along its normal: all that a contact needs that rotates
/// nothing. All functions are inlined, so that the members stay in registers.
struct CentresFrame {
  NamedRows rows_a, rows_b;
  Lanes a[4], b[4];  // velocities: x, y, angular, inverse mass
  Lanes normal_x, normal_y;
  Lanes mass_a, mass_b, mass;  // inverse, the last is their sum, 1/kg
  Lanes normal;                // relative velocity of the centres, m/s
  Lanes normal_sum;            // N s applied so far

  template <class Contacts>
  [[gnu::always_inline]] CentresFrame(const Contacts& contacts, Real* velocity)
      : rows_a{velocity, contacts.a},
        rows_b{velocity, contacts.b},
        normal_x(load(contacts.normal_x)),
        normal_y(load(contacts.normal_y)),
        normal_sum(Lanes::all(0)) {
    Lanes::gather(rows_a, a);
    Lanes::gather(rows_b, b);
    weigh(a[3], b[3]);
    normal = normal_x * (b[0] - a[0]) + normal_y * (b[1] - a[1]);
  }
  [[gnu::always_inline]] void weigh(const Lanes& inverse_a, const Lanes& inverse_b) {
    mass_a = inverse_a;
    mass_b = inverse_b;
    mass = mass_a + mass_b;
  }

  [[gnu::always_inline]] Lanes normal_velocity(const SmoothPointLanes&) const { return normal; }
  [[gnu::always_inline]] void push_normal(const SmoothPointLanes&, const Lanes& impulse) {
    normal = normal + impulse * mass;
    normal_sum = normal_sum + impulse;
  }
  /// Applies an impulse (N s, world frame) at the centres, without updating the frame.
  [[gnu::always_inline]] void give(const Lanes& x, const Lanes& y) {
    a[0] = a[0] - mass_a * x;
    a[1] = a[1] - mass_a * y;
    b[0] = b[0] + mass_b * x;
    b[1] = b[1] + mass_b * y;
  }
  /// The same, updating the frame.
  [[gnu::always_inline]] void push_centres(const Lanes& x, const Lanes& y) {
    give(x, y);
    normal = normal + mass * (normal_x * x + normal_y * y);
  }
  [[gnu::always_inline]] void write_back() {
    give(normal_sum * normal_x, normal_sum * normal_y);
    scatter();
  }
  [[gnu::always_inline]] void scatter() {
    Lanes::scatter(a, rows_a);
    Lanes::scatter(b, rows_b);
  }
};

/// The two bodies along normal and tangent: ContactFrame (contact_rows.h) in lanes, line by line.
struct LanesFrame : CentresFrame {
  Lanes inertia_a, inertia_b;
  Lanes tangent;  // relative velocity of the centres, m/s
  Lanes wa, wb;   // rad/s
  Lanes tangent_sum;

  template <class Contacts>
  [[gnu::always_inline]] LanesFrame(const Contacts& contacts, Real* velocity)
      : CentresFrame(contacts, velocity),
        inertia_a(load(contacts.inertia_a)),
        inertia_b(load(contacts.inertia_b)),
        tangent(normal_x * (b[1] - a[1]) - normal_y * (b[0] - a[0])),
        wa(a[2]),
        wb(b[2]),
        tangent_sum(Lanes::all(0)) {}

  [[gnu::always_inline]] Lanes normal_velocity(const PointLanes& p) const {
    return normal + wb * load(p.cross_b) - wa * load(p.cross_a);
  }
  [[gnu::always_inline]] Lanes tangent_velocity(const PointLanes& p) const {
    return tangent + wb * load(p.dot_b) - wa * load(p.dot_a);
  }

  [[gnu::always_inline]] void push_normal(const PointLanes& p, const Lanes& impulse) {
    CentresFrame::push_normal(p, impulse);
    wa = wa - impulse * inertia_a * load(p.cross_a);
    wb = wb + impulse * inertia_b * load(p.cross_b);
  }
  [[gnu::always_inline]] void push_tangent(const PointLanes& p, const Lanes& impulse) {
    tangent = tangent + impulse * mass;
    wa = wa - impulse * inertia_a * load(p.dot_a);
    wb = wb + impulse * inertia_b * load(p.dot_b);
    tangent_sum = tangent_sum + impulse;
  }
  [[gnu::always_inline]] void push_centres(const Lanes& x, const Lanes& y) {
    CentresFrame::push_centres(x, y);
    tangent = tangent + mass * (normal_x * y - normal_y * x);
  }
  [[gnu::always_inline]] void write_back() {
    // The sums as a vector in the world frame.
    const Lanes x = normal_sum * normal_x - tangent_sum * normal_y;
    const Lanes y = normal_sum * normal_y + tangent_sum * normal_x;
    give(x, y);
    a[2] = wa;
    b[2] = wb;
    scatter();
  }
};

template <class Contacts>
constexpr bool is_discs = requires(Contacts contacts) {
  contacts.between_x;
};
/// Whether the contacts have friction and rotate bodies.
template <class Contacts>
constexpr bool rubs = requires(Contacts contacts) {
  contacts.friction;
};
template <class Contacts>
using FrameOf = std::conditional_t<rubs<Contacts>, LanesFrame, CentresFrame>;

/// Whether pairs of points are solved together, as a type.
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
      case LanesKind::smooth:
        for (std::uint32_t i = run->begin; i < run->end; ++i) solve(table.smooth[i], Block<false>());
        break;
      case LanesKind::smooth_discs:
        for (std::uint32_t i = run->begin; i < run->end; ++i) solve(table.smooth_discs[i], Block<false>());
        break;
    }
  }
}

template <class Contacts>
constexpr std::uint32_t count_points(const Contacts& contacts) {
  return std::extent_v<decltype(contacts.point)>;
}

void lay_out_contacts(const ContactTable& table, const LayoutInput& input);
void store_contacts(const ContactTable& table, const LayoutInput& input);

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
