#include "solver/line_search.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// E(x) - E(0) = slope x + bend x^2 / 2, in J.
struct Parabola {
  Real slope = 0;
  Real bend = 0;

  bool rises_to(Real x) const { return x * (slope + bend * x / 2) > 0; }
  Real lowest_below(Real most) const { return slope < 0 && bend > 0 ? std::min(-slope / bend, most) : Real{0}; }
};

using RowImpulses = std::array<Vec2, 2>;  // N s, along normal and tangent, of each point

/// Adds the slope of the energy along a row's impulses; `bias(row, point)`: see LineSearch.
template <class Bias>
void add_slope(const ImpactRow& row, const ContactFrame& frame, const RowImpulses& impulses, Bias bias,
               Parabola& energy) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& p = row.points[i];
    const Vec2 j = impulses[i];
    energy.slope += j.x * (frame.normal_velocity(p) + bias(row, i)) + j.y * frame.tangent_velocity(p);
  }
}

void add_bend(const Island& island, const BodySet& bodies, const std::vector<Velocity>& changes, Parabola& energy) {
  for (const std::uint32_t body : island.bodies) {
    const InverseMass& inverse = bodies.inverse_mass[body];
    const Velocity& by = changes[body];
    if (inverse.m > 0) energy.bend += dot(by.v, by.v) / inverse.m;
    if (inverse.i > 0) energy.bend += by.w * by.w / inverse.i;
  }
}

/// The energy along impulses that change the velocities of the bodies by `changes`. `velocity(body)`: where the line
/// begins.
template <class Velocities>
Parabola along(const Island& island, const BodySet& bodies, Velocities velocity,
               const std::vector<RowImpulses>& impulses, const std::vector<Velocity>& changes) {
  constexpr auto unbiased = [](const ImpactRow&, std::size_t) { return Real{0}; };
  Parabola energy;
  for (std::size_t r = 0; r < island.acting.size(); ++r) {
    const ImpactRow& row = island.rows[island.acting[r]];
    add_slope(row, ContactFrame(row, velocity(row.a), velocity(row.b)), impulses[r], unbiased, energy);
  }
  add_bend(island, bodies, changes, energy);
  return energy;
}

/// Adds what a row's impulses change of its bodies' velocities. Bodies that cannot be pushed are not written: they may
/// belong to other islands too.
void add_change(const ImpactRow& row, const RowImpulses& impulses, std::vector<Velocity>& changes) {
  const bool on_a = pushable(row.mass_a);
  const bool on_b = pushable(row.mass_b);
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& p = row.points[i];
    const Vec2 j = impulses[i];
    const Vec2 push = j.x * row.normal + j.y * perpendicular(row.normal);
    if (on_a) {
      changes[row.a].v -= row.mass_a.m * push;
      changes[row.a].w -= row.mass_a.i * (j.x * p.cross_a + j.y * p.dot_a);
    }
    if (on_b) {
      changes[row.b].v += row.mass_b.m * push;
      changes[row.b].w += row.mass_b.i * (j.x * p.cross_b + j.y * p.dot_b);
    }
  }
}

void clear(const Island& island, std::vector<Velocity>& changes) {
  for (const std::uint32_t body : island.bodies) changes[body] = {};
}

Velocity sum(const Velocity& v, Real x, const Velocity& by) { return {v.v + x * by.v, v.w + x * by.w}; }

}  // namespace

void LineSearch::spread(const Island& island, const Impulses& impulses, std::vector<Velocity>& changes) {
  clear(island, changes);
  for (std::size_t r = 0; r < island.acting.size(); ++r) {
    add_change(island.rows[island.acting[r]], impulses[r], changes);
  }
}

void LineSearch::list(const Island& island, Impulses& impulses) {
  impulses.clear();
  for (const std::uint32_t row : island.acting) {
    const auto& [p, q] = island.rows[row].points;
    impulses.push_back({Vec2{p.normal_impulse, p.tangent_impulse}, Vec2{q.normal_impulse, q.tangent_impulse}});
  }
}

void LineSearch::temper(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration,
                        std::vector<Velocity>& kicks, std::vector<Velocity>& changes) {
  list(island, last_);
  spread(island, last_, kicks);
  const auto flown = [&](std::uint32_t body) { return sum(bodies.velocity[body], island.h, acceleration[body]); };
  const auto guess = [&] { return along(island, bodies, flown, last_, kicks); };
  if (!guess().rises_to(1)) return;

  direction_ = last_;
  for (std::size_t r = 0; r < direction_.size(); ++r) {
    for (std::size_t i = 0; i < 2; ++i) direction_[r][i] -= 2 * island.rows[island.acting[r]].half[i];
  }
  spread(island, direction_, changes);
  const auto before = [&](std::uint32_t body) { return sum(sum(flown(body), 1, kicks[body]), -1, changes[body]); };
  const Real share = along(island, bodies, before, direction_, changes).lowest_below(1);
  for (const std::uint32_t body : island.bodies) kicks[body] = sum(kicks[body], share - 1, changes[body]);
  for (std::size_t r = 0; r < last_.size(); ++r) {
    for (std::size_t i = 0; i < 2; ++i) last_[r][i] += (share - 1) * direction_[r][i];
  }

  const Parabola from_none = guess();
  const Real rest = from_none.rises_to(1) ? from_none.lowest_below(1) : Real{1};
  for (std::size_t r = 0; r < last_.size(); ++r) {
    ImpactRow& row = island.rows[island.acting[r]];
    for (std::size_t i = 0; i < 2; ++i) {
      row.points[i].normal_impulse = std::max(rest * last_[r][i].x, Real{0});
      row.points[i].tangent_impulse = rest * last_[r][i].y;
    }
  }
}

void LineSearch::begin(const Island& island) {
  list(island, last_);
  direction_.assign(last_.size(), {});
  change_ = 0;
}

void LineSearch::go_on(const Island& island, BodySet& bodies, std::vector<Velocity>& changes, bool pressing) {
  Real change = 0;
  for (std::size_t r = 0; r < island.acting.size(); ++r) {
    for (std::size_t i = 0; i < 2; ++i) {
      const RowPoint& p = island.rows[island.acting[r]].points[i];
      const Vec2 by = Vec2{p.normal_impulse, p.tangent_impulse} - last_[r][i];
      change += dot(by, by);
      last_[r][i] = by;
    }
  }
  // The first sweep has no direction before it; one that changed more than the last begins anew.
  const Real ratio = change_ > 0 && change <= change_ ? change / change_ : Real{0};
  change_ = change;

  Real share = 0;
  if (ratio > 0) {
    const auto bias = [&](const ImpactRow& row, std::size_t i) {
      if (!pressing) return Real{0};
      return row.gaps[i] > 0 ? row.gaps[i] / island.h : island.softness(row).bias_rate * row.gaps[i];
    };
    Real room = 1;
    Parabola energy;
    clear(island, changes);
    for (std::size_t r = 0; r < island.acting.size(); ++r) {
      const ImpactRow& row = island.rows[island.acting[r]];
      for (std::size_t i = 0; i < 2; ++i) {
        Vec2& go = direction_[r][i];
        go = ratio * go;
        if (go.x < 0) room = std::min(room, row.points[i].normal_impulse / -go.x);
      }
      add_change(row, direction_[r], changes);
      add_slope(row, ContactFrame(row, bodies.velocity[row.a], bodies.velocity[row.b]), direction_[r], bias, energy);
    }
    add_bend(island, bodies, changes, energy);
    share = energy.lowest_below(room);
    for (const std::uint32_t body : island.bodies) {
      if (bodies.pushable(body)) bodies.velocity[body] = sum(bodies.velocity[body], share, changes[body]);
    }
  }
  for (std::size_t r = 0; r < island.acting.size(); ++r) {
    ImpactRow& row = island.rows[island.acting[r]];
    for (std::size_t i = 0; i < 2; ++i) {
      RowPoint& p = row.points[i];
      const Vec2 more = share * direction_[r][i];
      p.normal_impulse = std::max(p.normal_impulse + more.x, Real{0});
      p.tangent_impulse += more.y;
      direction_[r][i] = more + last_[r][i];
      last_[r][i] = {p.normal_impulse, p.tangent_impulse};
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
