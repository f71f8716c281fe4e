#include "solver/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/restitution.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Points closer than this (m) at an impact are solved together: a box that lands flat must not start to spin.
constexpr Real together = static_cast<Real>(0.0005);

/// Directions whose determinant is below this share of the product of their inverse masses move as one: two points of a
/// door move as its hinge turns. It is far above rounding, and far below what two points of one body have.
constexpr Real as_one = static_cast<Real>(1e-5);

bool independent(const Mat22& k) { return k.determinant() > as_one * k.x.x * k.y.y; }

/// The coefficient up to which friction stops the tangential velocity vt, m/s. A point that slips when it hits slips
/// until friction has stopped it, and meanwhile friction is the dynamic one; only where nothing slips the static
/// coefficient counts.
Real grip_at(const ContactRow& row, Real vt) {
  return std::abs(vt) > no_speed ? row.dynamic_friction : row.static_friction;
}

}  // namespace

Collision::Collision(ImpactRow& row, const Velocity& a, const Velocity& b) : row_(row) {
  const ContactFrame frame(row, a, b);
  std::array<RowPoint*, 2> hit{&row.points[0], &row.points[1]};
  if (row.count == 2) {
    const auto approaches = [&](const RowPoint& p) { return frame.normal_velocity(p) < 0; };
    if (!approaches(*hit[0]) || (approaches(*hit[1]) && hit[1]->separation < hit[0]->separation)) {
      std::swap(hit[0], hit[1]);
    }
    if (hit[1]->separation < together && approaches(*hit[1])) count_ = 2;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    points_[i] = {hit[i], {frame.normal_velocity(*hit[i]), frame.tangent_velocity(*hit[i])}, {}};
  }
}

void Collision::couple() {
  const InverseMass& a = row_.mass_a;
  const InverseMass& b = row_.mass_b;
  for (std::size_t at = 0; at < count_; ++at) {
    for (std::size_t to = 0; to < count_; ++to) {
      const RowPoint& p = *points_[at].row;
      const RowPoint& q = *points_[to].row;
      k_[at][to] = {{a.m + b.m + a.i * p.cross_a * q.cross_a + b.i * p.cross_b * q.cross_b,
                     a.i * p.dot_a * q.cross_a + b.i * p.dot_b * q.cross_b},
                    {a.i * p.cross_a * q.dot_a + b.i * p.cross_b * q.dot_b,
                     a.m + b.m + a.i * p.dot_a * q.dot_a + b.i * p.dot_b * q.dot_b}};
    }
  }
}

void Collision::push(std::size_t at, Vec2 j) {
  points_[at].j += j;
  for (std::size_t i = 0; i < count_; ++i) points_[i].v += k_[i][at] * j;
}

void Collision::solve() {
  if (count_ == 2) {
    solve_two();
  } else {
    solve_one();
  }
  for (const Point& p : points()) {
    p.row->total_normal += p.j.x;
    p.row->total_tangent += p.j.y;
  }
}

/// Satisfies both laws: the normal velocity is reversed and multiplied by e, and the tangential one is stopped if
/// Coulomb's cone allows, otherwise opposed by mu J. Newton's law with friction can create energy at eccentric impacts
/// (Kane and Levinson 1985): then the point rebounds by the largest share of e that creates none. It fails if kn + mu
/// knt <= 0 (Painleve): then the normal impulse is computed without friction, and friction only removes energy.
void Collision::solve_one() {
  const Vec2 v = points_[0].v;
  const Mat22& k = k_[0][0];
  const Real wanted = -(1 + row_.restitution) * v.x;
  if (wanted <= 0 || !(k.x.x > 0)) return;  // by rounding: a point that hits approaches, and what is pushed moves
  if (!independent(k)) return push(0, {wanted / k.x.x, 0});

  const Real grip = grip_at(row_, v.y);
  const auto impulse = [&](Real share) {
    const Real parts = -(1 + share * row_.restitution) * v.x;
    Vec2 j = k.solve({parts, -v.y});  // sticks
    if (std::abs(j.y) > grip * j.x) {
      const Real mu = j.y < 0 ? -row_.dynamic_friction : row_.dynamic_friction;
      j.x = parts / (k.x.x + mu * k.y.x);
      j.y = mu * j.x;
    }
    return j;
  };
  const auto work = [&](Real share) {
    const Vec2 j = impulse(share);
    return j.x > 0 ? dot(j, v) + dot(j, k * j) / 2 : std::numeric_limits<Real>::infinity();
  };
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * wanted / k.x.x * std::abs(v.x);
  Real share = 1;
  if (const Real done = work(1); done > rounding) share = largest_share(done, work);
  if (!(work(share) > rounding)) return push(0, impulse(share));
  Vec2 j{wanted / k.x.x, 0};
  j.y = -(v.y + k.x.y * j.x) / k.y.y;
  if (std::abs(j.y) > grip * j.x) j.y = std::copysign(row_.dynamic_friction * j.x, j.y);
  push(0, j);
}

/// The normal impulses solve the 2x2 complementarity problem K J + (1+e) v >= 0, J >= 0; then friction at each.
void Collision::solve_two() {
  const Mat22 k{{k_[0][0].x.x, k_[1][0].x.x}, {k_[0][1].x.x, k_[1][1].x.x}};
  const Vec2 wanted{-(1 + row_.restitution) * points_[0].v.x, -(1 + row_.restitution) * points_[1].v.x};
  Vec2 j;
  if (independent(k)) {
    j = k.solve(wanted);
    if (!(j.x >= 0 && j.y >= 0)) {
      j = k.x.y * wanted.x >= wanted.y * k.x.x ? Vec2{wanted.x / k.x.x, 0} : Vec2{0, wanted.y / k.y.y};
    }
  } else if (const Real sum = k.x.x + k.y.y; sum > 0) {
    j = (k * wanted) / (sum * sum);  // the least impulses: K = u u^T, J = u (u . b) / |u|^4
  }
  push(0, {j.x, 0});
  push(1, {j.y, 0});
  const Real slip = std::max(std::abs(points_[0].v.y), std::abs(points_[1].v.y));
  const auto stops = [&](Real mu) {
    const bool stops_first = rub(0, mu * j.x);
    return rub(1, mu * j.y) || stops_first;  // what one cannot bear, the other may
  };
  const Real grip = grip_at(row_, slip);
  if (!stops(grip) && grip != row_.dynamic_friction) stops(row_.dynamic_friction);
}

/// Friction of `most` N s at one of two points; returns whether it stopped the point.
bool Collision::rub(std::size_t at, Real most) {
  const Mat22& k = k_[at][at];
  if (!independent(k)) return true;
  const Real wanted = points_[at].j.y - points_[at].v.y / k.y.y;
  const Real held = clamp(wanted, -most, most);
  push(at, {0, held - points_[at].j.y});
  return held == wanted;
}

void Collision::apply(Velocity& a, Velocity& b) const {
  ContactFrame frame(row_, a, b);
  for (std::size_t i = 0; i < count_; ++i) {
    frame.push_normal(row_, *points_[i].row, points_[i].j.x);
    frame.push_tangent(row_, *points_[i].row, points_[i].j.y);
  }
  frame.write_back(row_, a, b);
}

}  // namespace impulse::inline IMPULSE_PRECISION
