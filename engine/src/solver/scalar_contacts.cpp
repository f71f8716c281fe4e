#include "solver/scalar_contacts.h"

#include <algorithm>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Whether the row was made from the contact's current points; never for two discs, whose normal rotates with them.
bool keeps_points(const ImpactRow& row, const Contact& contact) {
  const auto same = [](const Pose& then, const Pose& now) { return then.p == now.p && then.q == now.q; };
  return row.made && !contact.discs() && same(row.found_a, contact.found_a) && same(row.found_b, contact.found_b) &&
         row.normal == contact.normal && row.found_separation == contact.found_separation;
}

/// Updates a row whose contact kept its points: only their separations and impulses are new.
void update(ImpactRow& row, const Contact& contact) {
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

/// The change of an impulse, given along a normal and its tangent, when these turn.
Vec2 redirected(Vec2 impulse, Vec2 from, Vec2 to) {
  const Vec2 change = to - from;
  return impulse.x * change + impulse.y * perpendicular(change);
}

/// Friction at all points: stops the sliding as far as the friction cone of the accumulated normal impulse allows. Two
/// points of a contact slide together, so each stops its part, in proportion to what it bears: whichever is listed
/// first, and however little one bears more than the other.
template <class Frame>
[[gnu::always_inline]] inline void solve_friction_by_state(ImpactRow& row, Frame& frame) {
  const auto stop = [&](RowPoint& p, Real sliding) {
    const Real wanted = p.tangent_impulse - p.tangent_mass * sliding;
    const Real most = row.friction() * p.normal_impulse;
    const Real held = clamp(wanted, -most, most);
    frame.push_tangent(row, p, held - p.tangent_impulse);
    p.tangent_impulse = held;
  };
  auto& [p, q] = row.points;
  if (row.count < 2) return stop(p, frame.tangent_velocity(p));
  const Real load = p.normal_impulse + q.normal_impulse;
  const Real share = load > 0 ? p.normal_impulse / load : Real{1} / 2;
  const Real of_p = share * frame.tangent_velocity(p);
  const Real of_q = (1 - share) * frame.tangent_velocity(q);
  stop(p, of_p);
  stop(q, of_q);
}

/// Solves both points together for these velocity changes, K d = change with K = `inverse_mass` and `coupling`: a point
/// that would pull bears nothing, and the other is solved without it. False if the points are almost in one place.
template <class Frame>
[[gnu::always_inline]] inline bool push_both(const PairMatrix& masses, const std::array<Real, 2>& inverse_mass,
                                             Real coupling, ImpactRow& row, Frame& frame, Vec2 change) {
  if (!masses.usable) return false;
  auto& [p, q] = row.points;
  Vec2 total = Vec2{p.normal_impulse, q.normal_impulse} + masses * change;
  if (total.x < 0 || total.y < 0) {
    // What each would bear alone, and whether q parts from p's impulse. K is positive definite, so that one of the four
    // answers alone is right: neither both nor p, hence q if it pushes.
    const Real of_p = p.normal_impulse + (change.x + coupling * q.normal_impulse) / inverse_mass[0];
    const Real of_q = q.normal_impulse + (change.y + coupling * p.normal_impulse) / inverse_mass[1];
    const Real left_q = change.y + inverse_mass[1] * q.normal_impulse - coupling * (of_p - p.normal_impulse);
    const bool only_p = of_p >= 0 && left_q <= 0;
    total = only_p ? Vec2{of_p, 0} : Vec2{0, std::max(Real{0}, of_q)};
  }
  apply_accumulated(row, p, frame, total.x);
  apply_accumulated(row, q, frame, total.y);
  return true;
}

}  // namespace

void renew(ImpactRow& row, const BodySet& bodies, const std::vector<Pose>& start, const std::vector<Contact>& contacts,
           std::uint32_t index) {
  const Contact& contact = contacts[index];
  if (keeps_points(row, contact)) {
    update(row, contact);
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
  row.slips = contact.slips;
}

void write_back(ImpactRow& row, Real offset_scale, std::vector<Contact>& contacts) {
  Contact& contact = contacts[row.contact];
  contact.offset = row.offset / offset_scale;
  contact.slips = row.slips;
  if (row.turns) {
    auto& [p, q] = row.points;
    const std::array<Vec2, 2> total =
        reported(row.effect, {{{p.total_normal, p.total_tangent}, {q.total_normal, q.total_tangent}}}, row.mass_a,
                 row.mass_b, contact);
    for (std::size_t i = 0; i < 2; ++i) {
      row.points[i].total_normal = total[i].x;
      row.points[i].total_tangent = total[i].y;
    }
    contact.forget_place();
  }
  store_row(row, contacts);
}

template <class Solve>
void ScalarContacts::in_frame(ImpactRow& row, std::vector<Velocity>& velocity, Solve solve) {
  Velocity& a = velocity[row.a];
  Velocity& b = velocity[row.b];
  const auto solve_in = [&](auto frame) {
    solve(row, frame);
    frame.write_back(row, a, b);
  };
  if (!row.stirs_a) return solve_in(FrameOf<false, true>(row, a, b));
  if (!row.stirs_b) return solve_in(FrameOf<true, false>(row, a, b));
  solve_in(ContactFrame(row, a, b));
}

template <class Solve>
void ScalarContacts::each_of(const Island& island, std::span<const std::uint32_t> rows, Solve solve) {
  for (const std::uint32_t row : rows) in_frame(island.rows[row], bodies_.velocity, solve);
}

void ScalarContacts::measure(const Island& island) const {
  for (ImpactRow& row : island.rows) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      row.gaps[i] = separation(row, row.points[i], motion_[row.a], motion_[row.b]) - row.offset;
    }
  }
}

void ScalarContacts::leave_out_far(const Island& island) const {
  const auto bears = [](const RowPoint& p) { return p.normal_impulse != 0 || p.tangent_impulse != 0; };
  for (ImpactRow& row : island.rows) {
    const bool goes_on = row.active || !island.bounces;  // and not to an impact of its own
    row.active = goes_on && (bears(row.points[0]) || bears(row.points[1]) ||
                             row.nearest() <= near_by + 2 * island.h * fastest_nearing(row, bodies_));
  }
}

void ScalarContacts::halve(const Island& island, std::vector<Velocity>& kicks) const {
  for (const std::uint32_t body : island.bodies) kicks[body] = {};
  for (ImpactRow& row : island.rows) {
    if (row.disc_distance > 0) face(row);
    const auto count = static_cast<std::size_t>(row.count);
    for (std::size_t i = 0; i < count; ++i) {
      RowPoint& p = row.points[i];
      row.half[i] = row.active ? Vec2{p.normal_impulse / 2, p.tangent_impulse / 2} : Vec2{};
      p.normal_impulse = 0;
      p.tangent_impulse = 0;
    }
    if (count < 2) row.half[1] = {};
    if (!row.active) continue;
    in_frame(row, kicks, [count](ImpactRow& halved, auto& frame) {
      for (std::size_t i = 0; i < count; ++i) {
        frame.push_normal(halved, halved.points[i], halved.half[i].x);
        frame.push_tangent(halved, halved.points[i], halved.half[i].y);
      }
    });
  }
}

void ScalarContacts::meet(const Island& island, Real slow) const {
  for (ImpactRow& row : island.rows) {
    if (!row.two_frictions() || row.points[0].normal_impulse > 0 || row.points[1].normal_impulse > 0) continue;
    const ContactFrame frame(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
    row.slips = std::any_of(row.points.begin(), row.points.begin() + row.count,
                            [&](const RowPoint& p) { return std::abs(frame.tangent_velocity(p)) > slow; });
  }
}

bool ScalarContacts::stick_or_slip(const Island& island, Real slow_in_web) const {
  bool broke = false;
  for (ImpactRow& row : island.rows) {
    if (!row.active || !row.two_frictions()) continue;
    const Real mu = row.friction();
    const ContactFrame frame(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
    bool slips = true;
    bool moves = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      slips = slips && std::abs(p.tangent_impulse) >= mu * p.normal_impulse;
      moves = moves || std::abs(frame.tangent_velocity(p)) > (row.web ? slow_in_web : no_slip);
    }
    slips = slips && moves;
    broke |= slips && !row.slips;
    row.slips = slips;
  }
  return broke;
}

void ScalarContacts::count_halves(const Island& island) {
  for (ImpactRow& row : island.rows) {
    if (!row.active) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      row.points[i].normal_impulse += row.half[i].x;
      row.points[i].tangent_impulse += row.half[i].y;
    }
    if (row.disc_distance > 0) turn_normal(row);
  }
}

/// Rotates the normal of two discs to where they are.
void ScalarContacts::face(ImpactRow& row) const {
  row.normal = normalized(row.between + (motion_[row.b].d - motion_[row.a].d));
  // gap() measures along the normal from `between`: for discs that is their distance less the radii.
  row.points[0].separation = dot(row.normal, row.between) - row.disc_distance;
}

/// Rotates the normal of two discs with them, and with it the impulses of this sub-step. Otherwise the difference of
/// the impulses that press applied and relax removes would have a tangential part that no contact reports.
void ScalarContacts::turn_normal(ImpactRow& row) {
  const RowPoint& p = row.points[0];
  row.led = row.normal;
  face(row);
  push_centres(row, redirected({p.normal_impulse, p.tangent_impulse}, row.led, row.normal));
}

/// What a disc bore before it drifted acted along the normal of then: along the turned one it would do work, F v^2 / 2R
/// on a disc that slides over a dome. So of the half that was given before the drift, what the contact bears in the end
/// turns back.
void ScalarContacts::turn_back(const Island& island) {
  for (ImpactRow& row : island.rows) {
    if (row.disc_distance == 0 || !row.active) continue;
    const RowPoint& p = row.points[0];
    const Vec2 half = row.half[0];
    const Vec2 early{std::min(half.x, p.normal_impulse),
                     clamp(half.y, std::min(p.tangent_impulse, Real{0}), std::max(p.tangent_impulse, Real{0}))};
    const Vec2 more = redirected(early, row.normal, row.led);
    push_centres(row, more);
    row.effect.impulse += more;
  }
}

void ScalarContacts::push_centres(const ImpactRow& row, Vec2 impulse) {
  if (row.mass_a.m > 0) bodies_.velocity[row.a].v -= row.mass_a.m * impulse;
  if (row.mass_b.m > 0) bodies_.velocity[row.b].v += row.mass_b.m * impulse;
}

void ScalarContacts::press(const Island& island) {
  each_of(island, island.acting, [&](ImpactRow& row, auto& frame) { press_row<false>(island, row, frame); });
}

void ScalarContacts::press_rigidly(const Island& island, std::span<const std::uint32_t> rows) {
  each_of(island, rows, [&](ImpactRow& row, auto& frame) { press_row<true>(island, row, frame); });
}

void ScalarContacts::relax(const Island& island, std::span<const std::uint32_t> rows) {
  each_of(island, rows, [](ImpactRow& row, auto& frame) { relax_row(row, frame); });
}

template <bool rigidly, class Frame>
[[gnu::always_inline]] inline void ScalarContacts::press_row(const Island& island, ImpactRow& row, Frame& frame) {
  if (!row.block || !press_pair<rigidly>(island, row, frame)) {
    Softness soft = island.softness(row);
    if constexpr (rigidly) soft = {.bias_rate = soft.bias_rate};
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      const Real s = row.gaps[i] + row.parts[i] * island.h;
      const Real v = frame.normal_velocity(p) - row.parts[i];
      const Real push = s > touching_gap ? -p.normal_mass * (v + s / island.h)
                                         : -p.normal_mass * soft.mass_scale * (v + soft.bias_rate * s) -
                                               soft.impulse_scale * p.normal_impulse;
      apply_accumulated(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
    }
  }
  if (row.fresh) solve_friction_by_state(row, frame);
}

template <class Frame>
[[gnu::always_inline]] inline void ScalarContacts::relax_row(ImpactRow& row, Frame& frame) {
  if (!row.block || !relax_pair(row, frame)) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      if (p.normal_impulse == 0 && row.gaps[i] > touching_gap) continue;
      const Real push = -p.normal_mass * frame.normal_velocity(p);
      apply_accumulated(row, p, frame, std::max(p.normal_impulse + push, Real{0}));
    }
  }
  solve_friction_by_state(row, frame);
}

bool ScalarContacts::deepens(const Island& island, Real in_step, bool held) const {
  return std::any_of(island.acting.begin(), island.acting.end(),
                     [&](std::uint32_t row) { return deepens(island, island.rows[row], in_step, held); });
}

bool ScalarContacts::deepens(const Island& island, const ImpactRow& row, Real in_step, bool held) const {
  const auto felt = [&](Real growth) { return growth * static_cast<Real>(island.substeps) > in_step; };
  const ContactFrame frame(row, bodies_.velocity[row.a], bodies_.velocity[row.b]);
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& p = row.points[i];
    const Real parts = held ? 0 : row.parts[i] * island.h;
    const Real closing = parts - island.h * frame.normal_velocity(p);
    if (!felt(closing)) continue;  // an upper bound of the growth
    const Real s = row.gaps[i] + parts;
    if (held && p.normal_impulse == 0 && s > touching_gap) continue;
    if (felt(held ? closing : std::min(s, Real{0}) - (s - closing))) return true;
  }
  return false;
}

PointPair ScalarContacts::pair_of(const Island& island, const ImpactRow& row) {
  const auto& [p, q] = row.points;
  const Real strength = island.softness(row).mass_scale;
  const Real weakness = 1 / strength - 1;
  PointPair pair{.strength = strength,
                 .inverse_mass = {1 / p.normal_mass, 1 / q.normal_mass},
                 .coupling = row.mass_a.m + row.mass_b.m + row.mass_a.i * p.cross_a * q.cross_a +
                             row.mass_b.i * p.cross_b * q.cross_b,
                 .give = {weakness / p.normal_mass, weakness / q.normal_mass}};
  pair.rigid = pair.matrix({});
  pair.soft = pair.matrix(pair.give);
  return pair;
}

/// (K + G) d = -(v + bias + G lambda) with G the compliance of the points that overlap.
template <bool rigidly, class Frame>
[[gnu::always_inline]] inline bool ScalarContacts::press_pair(const Island& island, ImpactRow& row, Frame& frame) {
  const PointPair& pair = row.pair;
  const Real rate = island.softness(row).bias_rate;
  const std::array<Real, 2> s{row.gaps[0] + row.parts[0] * island.h, row.gaps[1] + row.parts[1] * island.h};
  const auto change = [&](std::size_t i, Real give) {
    const RowPoint& point = row.points[i];
    const Real bias = (s[i] > touching_gap ? s[i] / island.h : rate * s[i]) + give * point.normal_impulse;
    return -(frame.normal_velocity(point) - row.parts[i] + bias);
  };
  if constexpr (rigidly) {
    return push_both(pair.rigid, pair.inverse_mass, pair.coupling, row, frame, {change(0, 0), change(1, 0)});
  }
  const std::array<Real, 2> give{s[0] > touching_gap ? 0 : pair.give[0], s[1] > touching_gap ? 0 : pair.give[1]};
  const std::array<Real, 2> inverse_mass{pair.inverse_mass[0] + give[0], pair.inverse_mass[1] + give[1]};
  const bool soft = !(s[0] > touching_gap) && !(s[1] > touching_gap);
  return push_both(soft ? pair.soft : pair.matrix(give), inverse_mass, pair.coupling, row, frame,
                   {change(0, give[0]), change(1, give[1])});
}

template <class Frame>
[[gnu::always_inline]] inline bool ScalarContacts::relax_pair(ImpactRow& row, Frame& frame) {
  const auto& [p, q] = row.points;
  for (std::size_t i = 0; i < 2; ++i) {
    if (row.points[i].normal_impulse == 0 && row.gaps[i] > touching_gap) return false;
  }
  return push_both(row.pair.rigid, row.pair.inverse_mass, row.pair.coupling, row, frame,
                   {-frame.normal_velocity(p), -frame.normal_velocity(q)});
}

/// A steady load causes penetration in soft contacts. The offset, one for both points of a contact (one each would
/// remove the stiffness that keeps a column upright), slowly moves the rest length until the surfaces just touch; it
/// never exceeds the penetration that the load explains, load / (2 m_eff w^2), and vanishes with the load (see
/// OffsetRule). Points are weighted by their loads: a body that leans on one corner has the other in the air. Near an
/// even load that is the mean, and removes no stiffness.
void ScalarContacts::settle_offsets(const Island& island) {
  for (ImpactRow& row : island.rows) {
    const Softness& soft = island.softness(row);
    Real load = 0;
    Real speed = 0;  // lambda / m_eff
    Real depth = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      load += p.normal_impulse;
      speed += p.normal_impulse * (p.normal_impulse / p.normal_mass);
      depth -= p.normal_impulse * separation(row, p, motion_[row.a], motion_[row.b]);
    }
    // Not times 1 / load, which is infinite for a tiny load.
    if (load > 0) {
      speed /= load;
      depth /= load;
    }
    const Real explained = speed / (2 * island.h * soft.omega * soft.omega);
    if (island.settling) {
      row.offset = explained;
    } else if (row.age >= OffsetRule::from_age) {
      constexpr Real headroom = static_cast<Real>(1.05);
      const Real change = island.offsets.gain(soft) * depth - island.offsets.leak() * row.offset;
      row.offset = clamp(row.offset + change, 0, headroom * explained);
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
