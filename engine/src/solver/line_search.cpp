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

/// The energy along impulses that change the velocities of the bodies by `change(body)`. `velocity(body)`: where the
/// line begins.
template <class Velocities, class Impulse, class Bias, class Change>
Parabola along(const Island& island, const BodySet& bodies, Velocities velocity, Impulse impulse, Bias bias,
               Change change) {
  Parabola energy;
  for (std::size_t r = 0; r < island.rows.size(); ++r) {
    const ImpactRow& row = island.rows[r];
    if (!row.active) continue;
    const ContactFrame frame(row, velocity(row.a), velocity(row.b));
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      const Vec2 j = impulse(r, i);
      energy.slope += j.x * (frame.normal_velocity(p) + bias(row, p)) + j.y * frame.tangent_velocity(p);
    }
  }
  for (const std::uint32_t body : island.bodies) {
    const InverseMass& inverse = bodies.inverse_mass[body];
    const Velocity by = change(body);
    if (inverse.m > 0) energy.bend += dot(by.v, by.v) / inverse.m;
    if (inverse.i > 0) energy.bend += by.w * by.w / inverse.i;
  }
  return energy;
}

constexpr auto unbiased = [](const ImpactRow&, const RowPoint&) { return Real{0}; };

Velocity sum(const Velocity& v, Real x, const Velocity& by) { return {v.v + x * by.v, v.w + x * by.w}; }

}  // namespace

void LineSearch::spread(const Island& island, const Impulses& impulses, std::vector<Velocity>& changes) {
  for (const std::uint32_t body : island.bodies) changes[body] = {};
  for (std::size_t r = 0; r < island.rows.size(); ++r) {
    const ImpactRow& row = island.rows[r];
    if (!row.active) continue;
    // Bodies that cannot be pushed are not written: they may belong to other islands too.
    const bool on_a = pushable(row.mass_a);
    const bool on_b = pushable(row.mass_b);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      const Vec2 j = impulses[r][i];
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
}

void LineSearch::list(const Island& island, Impulses& impulses) {
  impulses.clear();
  for (const ImpactRow& row : island.rows) {
    const auto& [p, q] = row.points;
    impulses.push_back({Vec2{p.normal_impulse, p.tangent_impulse}, Vec2{q.normal_impulse, q.tangent_impulse}});
  }
}

void LineSearch::temper(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration,
                        std::vector<Velocity>& kicks, std::vector<Velocity>& changes) {
  list(island, last_);
  spread(island, last_, kicks);
  const auto flown = [&](std::uint32_t body) { return sum(bodies.velocity[body], island.h, acceleration[body]); };
  const auto guess = [&] {
    return along(
        island, bodies, flown, [&](std::size_t r, std::size_t i) { return last_[r][i]; }, unbiased,
        [&](std::uint32_t body) { return kicks[body]; });
  };
  if (!guess().rises_to(1)) return;

  direction_ = last_;
  for (std::size_t r = 0; r < direction_.size(); ++r) {
    for (std::size_t i = 0; i < 2; ++i) direction_[r][i] -= 2 * island.rows[r].half[i];
  }
  spread(island, direction_, changes);
  const auto before = [&](std::uint32_t body) { return sum(sum(flown(body), 1, kicks[body]), -1, changes[body]); };
  const Real share = along(
                         island, bodies, before, [&](std::size_t r, std::size_t i) { return direction_[r][i]; },
                         unbiased, [&](std::uint32_t body) { return changes[body]; })
                         .lowest_below(1);
  for (const std::uint32_t body : island.bodies) kicks[body] = sum(kicks[body], share - 1, changes[body]);
  for (std::size_t r = 0; r < last_.size(); ++r) {
    for (std::size_t i = 0; i < 2; ++i) last_[r][i] += (share - 1) * direction_[r][i];
  }

  const Parabola from_none = guess();
  const Real rest = from_none.rises_to(1) ? from_none.lowest_below(1) : Real{1};
  for (std::size_t r = 0; r < last_.size(); ++r) {
    ImpactRow& row = island.rows[r];
    if (!row.active) continue;
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

void LineSearch::go_on(const Island& island, BodySet& bodies, const std::vector<Motion>& motion,
                       std::vector<Velocity>& changes, bool pressing) {
  Real change = 0;
  for (std::size_t r = 0; r < island.rows.size(); ++r) {
    for (std::size_t i = 0; i < 2; ++i) {
      const RowPoint& p = island.rows[r].points[i];
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
    Real room = 1;
    for (std::size_t r = 0; r < island.rows.size(); ++r) {
      for (std::size_t i = 0; i < 2; ++i) {
        Vec2& go = direction_[r][i];
        go = ratio * go;
        if (go.x < 0) room = std::min(room, island.rows[r].points[i].normal_impulse / -go.x);
      }
    }
    spread(island, direction_, changes);
    const auto bias = [&](const ImpactRow& row, const RowPoint& p) {
      if (!pressing) return Real{0};
      const Real gap = separation(row, p, motion[row.a], motion[row.b]) - row.offset;
      return gap > 0 ? gap / island.h : island.softness(row).bias_rate * gap;
    };
    share = along(
                island, bodies, [&](std::uint32_t body) { return bodies.velocity[body]; },
                [&](std::size_t r, std::size_t i) { return direction_[r][i]; }, bias,
                [&](std::uint32_t body) { return changes[body]; })
                .lowest_below(room);
    for (const std::uint32_t body : island.bodies) {
      if (bodies.pushable(body)) bodies.velocity[body] = sum(bodies.velocity[body], share, changes[body]);
    }
  }
  for (std::size_t r = 0; r < island.rows.size(); ++r) {
    ImpactRow& row = island.rows[r];
    for (std::size_t i = 0; i < 2; ++i) {
      RowPoint& p = row.points[i];
      const Vec2 more = share * direction_[r][i];
      if (row.active) {
        p.normal_impulse = std::max(p.normal_impulse + more.x, Real{0});
        p.tangent_impulse += more.y;
      }
      direction_[r][i] = more + last_[r][i];
      last_[r][i] = {p.normal_impulse, p.tangent_impulse};
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
