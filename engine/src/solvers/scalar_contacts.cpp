#include "solvers/scalar_contacts.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

Real ScalarContacts::gap(const ImpactRow& row, const RowPoint& p) const {
  return separation(row, p, motion_[row.a], motion_[row.b]) - row.offset;
}

void ScalarContacts::halve(const Island& island) {
  for (ImpactRow& row : island.rows) {
    for (std::size_t i = 0; i < 2; ++i) {
      RowPoint& p = row.points[i];
      row.half[i] = row.active ? Vec2{p.normal_impulse / 2, p.tangent_impulse / 2} : Vec2{};
      p.normal_impulse = 0;
      p.tangent_impulse = 0;
    }
  }
}

void ScalarContacts::kick(const Island& island) {
  for (ImpactRow& row : island.rows) {
    if (!row.active) continue;
    if (row.disc_distance > 0) turn_normal(row);
    ContactFrame frame(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      frame.push_normal(row, p, row.half[i].x);
      frame.push_tangent(row, p, row.half[i].y);
      p.normal_impulse += row.half[i].x;
      p.tangent_impulse += row.half[i].y;
    }
    frame.leave(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
  }
}

/// The normal of two discs follows them, and with it what was given along it in this sub-step. What press gave and
/// relax takes back would else leave a push across, which no contact shows.
void ScalarContacts::turn_normal(ImpactRow& row) {
  RowPoint& p = row.points[0];
  const Vec2 before = row.normal;
  row.normal = normalized(row.between + (motion_[row.b].d - motion_[row.a].d));
  // gap() measures along the normal from `between`: for discs that is their distance less the radii.
  p.separation = dot(row.normal, row.between) - row.disc_distance;
  const Vec2 change = row.normal - before;
  const Vec2 more = p.normal_impulse * change + p.tangent_impulse * perpendicular(change);
  if (row.mass_a.m > 0) bodies_.velocity[row.a].v -= row.mass_a.m * more;
  if (row.mass_b.m > 0) bodies_.velocity[row.b].v += row.mass_b.m * more;
}

void ScalarContacts::press(const Island& island) {
  for (ImpactRow& row : island.rows) {
    if (!row.active) continue;
    const Softness& soft = island.softness(row);
    ContactFrame frame(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
    if (!row.block || !solve_pair(island, row, frame, true)) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        RowPoint& p = row.points[i];
        const Real s = gap(row, p);
        const Real v = frame.normal_velocity(p);
        const Real push = s > 0 ? -p.normal_mass * (v + s / island.h)
                                : -p.normal_mass * soft.strength * (v + soft.rate * s) - soft.relief * p.normal_impulse;
        push_to(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
      }
    }
    if (row.fresh) rub(row, frame);
    frame.leave(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
  }
}

void ScalarContacts::relax(const Island& island) {
  for (ImpactRow& row : island.rows) {
    if (!row.active) continue;
    ContactFrame frame(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
    if (!row.block || !solve_pair(island, row, frame, false)) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        RowPoint& p = row.points[i];
        if (p.normal_impulse == 0 && gap(row, p) > 0) continue;
        const Real push = -p.normal_mass * frame.normal_velocity(p);
        push_to(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
      }
    }
    rub(row, frame);
    frame.leave(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
  }
}

PointPair ScalarContacts::pair_of(const Island& island, const ImpactRow& row) {
  const auto& [p, q] = row.points;
  const Real weakness = 1 / island.softness(row).strength - 1;
  return {.inverse_mass = {1 / p.normal_mass, 1 / q.normal_mass},
          .coupling =
              row.mass_a.m + row.mass_b.m + row.mass_a.i * p.cross_a * q.cross_a + row.mass_b.i * p.cross_b * q.cross_b,
          .give = {weakness / p.normal_mass, weakness / q.normal_mass}};
}

/// Both points at once: (K + G) d = -(v + bias + G lambda) with G the springs' give; nothing if a point would pull.
bool ScalarContacts::solve_pair(const Island& island, ImpactRow& row, ContactFrame& frame, bool pressing) const {
  const Softness& soft = island.softness(row);
  std::array<Real, 2> give{};
  std::array<Real, 2> bias{};
  for (std::size_t i = 0; i < 2; ++i) {
    const RowPoint& p = row.points[i];
    if (pressing) {
      const Real s = gap(row, p);
      give[i] = s > 0 ? Real{0} : row.pair.give[i];
      bias[i] = s > 0 ? s / island.h : soft.rate * s;
    } else if (p.normal_impulse == 0 && gap(row, p) > 0) {
      return false;
    }
  }
  RowPoint& p = row.points[0];
  RowPoint& q = row.points[1];
  const Real k11 = row.pair.inverse_mass[0] + give[0];
  const Real k22 = row.pair.inverse_mass[1] + give[1];
  const Mat22 k({k11, row.pair.coupling}, {row.pair.coupling, k22});
  // Two points almost in one place: the matrix says nothing about the difference of their loads.
  constexpr Real worst_condition = 1000;
  if (k11 * k22 > worst_condition * k.determinant()) return false;
  const Vec2 change = k.solve({-(frame.normal_velocity(p) + bias[0] + give[0] * p.normal_impulse),
                               -(frame.normal_velocity(q) + bias[1] + give[1] * q.normal_impulse)});
  const Vec2 total = Vec2{p.normal_impulse, q.normal_impulse} + change;
  if (total.x < 0 || total.y < 0) return false;
  push_to(row, p, frame, total.x);
  push_to(row, q, frame, total.y);
  return true;
}

/// A standing load presses its springs in. The offset, one for both points of a contact (one each would take away the
/// stiffness that keeps a column upright), slowly moves the springs' rest length until the surfaces just touch; it
/// never exceeds the depth that the load explains, load / (2 m_eff w^2), and goes with the load.
void ScalarContacts::settle_offsets(const Island& island) {
  for (ImpactRow& row : island.rows) {
    const Real omega = island.softness(row).omega;
    Real speed = 0;  // lambda / m_eff
    Real depth = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      speed += p.normal_impulse / p.normal_mass;
      depth -= separation(row, p, motion_[row.a], motion_[row.b]);
    }
    const Real points = static_cast<Real>(row.count);
    const Real explained = speed / points / (2 * island.h * omega * omega);
    if (island.settling) {
      row.offset = explained;
    } else if (const Real rate = island.offset_rate(row.age); rate > 0) {
      constexpr Real headroom = static_cast<Real>(1.05);
      row.offset = clamp(row.offset + rate * depth / points, 0, headroom * explained);
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
