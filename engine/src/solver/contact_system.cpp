#include "solver/contact_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Of the largest term of a rate, what may be left of it.
constexpr Real may_remain = 64 * std::numeric_limits<Real>::epsilon();

/// Compliance, as a fraction of an unknown's own inverse mass, that decides between equal ways to share a load. It does
/// not stay: what it leaves is solved in the next round.
constexpr Real least_change = static_cast<Real>(sizeof(Real) == 8 ? 1e-9 : 1e-4);

/// Solves a x = b by elimination with partial pivoting; `a` is n x n, and b becomes x. False if it is singular.
bool eliminate(std::vector<Real>& a, std::vector<Real>& b) {
  const std::size_t n = b.size();
  const auto row = [&](std::size_t i) { return a.data() + i * n; };
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(row(i)[k]) > std::abs(row(pivot)[k])) pivot = i;
    }
    if (!(std::abs(row(pivot)[k]) > 0)) return false;
    if (pivot != k) {
      std::swap_ranges(row(k), row(k) + n, row(pivot));
      std::swap(b[k], b[pivot]);
    }
    const Real* from = row(k);
    for (std::size_t i = k + 1; i < n; ++i) {
      Real* to = row(i);
      const Real factor = to[k] / from[k];
      if (factor == 0) continue;
      for (std::size_t j = k + 1; j < n; ++j) to[j] -= factor * from[j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= row(k)[j] * b[j];
    b[k] /= row(k)[k];
  }
  return true;
}

}  // namespace

/// 1/kg, the change of this rate for a unit impulse along the other.
Real ContactSystem::Unknown::along(const Unknown& other) const {
  const auto through = [&](const InverseMass& mass, Real arm, Real other_arm) {
    return mass.m * dot(axis, other.axis) + mass.i * arm * other_arm;
  };
  Real sum = 0;
  if (a == other.a) sum += through(mass_a, arm_a, other.arm_a);
  if (b == other.b) sum += through(mass_b, arm_b, other.arm_b);
  if (a == other.b) sum -= through(mass_a, arm_a, other.arm_b);
  if (b == other.a) sum -= through(mass_b, arm_b, other.arm_a);
  return sum;
}

/// The points that take part in a stage, with their bias and compliance as ScalarContacts has them. Takes back
/// friction, which may act elsewhere between the points of a contact when they share its load in another way. False if
/// some overlap is deep.
bool ContactSystem::list(const Island& island, Stage stage, BodySet& bodies, const std::vector<Motion>& motion) {
  points_.clear();
  frictions_.clear();
  unknowns_.clear();
  impulse_.clear();
  bias_.clear();
  speed_ = 0;
  for (ImpactRow& row : island.rows) {
    if (!row.active) continue;
    Velocity& a = bodies.velocity[row.a];
    Velocity& b = bodies.velocity[row.b];
    const std::size_t first = points_.size();
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      const Real gap = separation(row, p, motion[row.a], motion[row.b]) - row.offset;
      if (gap < -deep_overlap) return false;
      Point point{.row = &p};
      Real bias = 0;
      if (stage == Stage::relax) {
        if (p.normal_impulse == 0 && gap > touching_gap) continue;
      } else if (gap > touching_gap) {
        bias = gap / island.h;
      } else if (stage == Stage::press_soft) {
        const Softness& soft = island.softness(row);
        bias = soft.bias_rate * gap;
        point.give = (1 / soft.mass_scale - 1) / p.normal_mass;
      }
      points_.push_back(point);
      unknowns_.push_back({row.a, row.b, row.mass_a, row.mass_b, row.normal, p.cross_a, p.cross_b});
      impulse_.push_back(p.normal_impulse);
      bias_.push_back(bias);
      const Real terms = length(a.v) + length(b.v) + std::abs(a.w * p.cross_a) + std::abs(b.w * p.cross_b);
      speed_ = std::max({speed_, terms, std::abs(bias), p.normal_impulse / p.normal_mass});
    }
    if (points_.size() == first) continue;
    const bool rubs = (stage == Stage::relax || row.fresh) && row.friction() > 0;
    if (rubs) {
      ContactFrame frame(row, a, b);
      for (std::size_t i = first; i < points_.size(); ++i) {
        frame.push_tangent(row, *points_[i].row, -points_[i].row->tangent_impulse);
      }
      frame.write_back(row, a, b);
    }
    frictions_.push_back({.row = &row, .first = first, .count = points_.size() - first, .unknown = rubs ? 0 : none});
  }
  for (Friction& friction : frictions_) {
    if (friction.unknown == none) continue;
    friction.unknown = unknowns_.size();
    const ImpactRow& row = *friction.row;
    unknowns_.push_back({row.a, row.b, row.mass_a, row.mass_b, perpendicular(row.normal)});
    Real sum = 0;
    for (std::size_t i = 0; i < friction.count; ++i) sum += points_[friction.first + i].row->tangent_impulse;
    impulse_.push_back(sum);
  }
  given_ = impulse_;
  std::fill(given_.begin() + static_cast<std::ptrdiff_t>(points_.size()), given_.end(), Real{0});
  return true;
}

/// Couples the unknowns and finds their rates at the present impulses.
void ContactSystem::measure(const BodySet& bodies) {
  const std::size_t n = unknowns_.size();
  k_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) k(i, j) = k(j, i) = unknowns_[i].along(unknowns_[j]);
  }
  rate_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Unknown& unknown = unknowns_[i];
    const Velocity& a = bodies.velocity[unknown.a];
    const Velocity& b = bodies.velocity[unknown.b];
    rate_[i] = dot(unknown.axis, b.v - a.v) + b.w * unknown.arm_b - a.w * unknown.arm_a;
    if (i < points_.size()) rate_[i] += bias_[i] + points_[i].give * impulse_[i];
    for (std::size_t j = 0; j < n; ++j) rate_[i] += k(i, j) * (impulse_[j] - given_[j]);
  }
}

Real ContactSystem::load(const Friction& friction) const {
  Real sum = 0;
  for (std::size_t i = 0; i < friction.count; ++i) sum += std::max(impulse_[friction.first + i], Real{0});
  return sum;
}

/// The part of a contact's friction that acts at one of its points: as it bears the load.
Real ContactSystem::share(const Friction& friction, std::size_t point) const {
  if (friction.count == 1) return 1;
  const Real all = load(friction);
  return all > 0 ? std::max(impulse_[friction.first + point], Real{0}) / all : 1 / static_cast<Real>(friction.count);
}

/// Places friction between the points as they bear the load now. Returns whether any has moved by more than rounding.
bool ContactSystem::place_friction() {
  bool moved = false;
  for (const Friction& friction : frictions_) {
    if (friction.unknown == none) continue;
    Unknown& unknown = unknowns_[friction.unknown];
    Real arm_a = 0;
    Real arm_b = 0;
    for (std::size_t i = 0; i < friction.count; ++i) {
      const Real part = share(friction, i);
      arm_a += part * points_[friction.first + i].row->dot_a;
      arm_b += part * points_[friction.first + i].row->dot_b;
    }
    const auto differ = [](Real then, Real now) { return std::abs(now - then) > may_remain * std::abs(now); };
    moved = moved || differ(unknown.arm_a, arm_a) || differ(unknown.arm_b, arm_b);
    unknown.arm_a = arm_a;
    unknown.arm_b = arm_b;
  }
  return moved;
}

Real ContactSystem::mass(std::size_t unknown) const {
  const Real inverse = k(unknown, unknown) + (unknown < points_.size() ? points_[unknown].give : Real{0});
  return inverse > 0 ? 1 / inverse : Real{0};
}

/// m/s, by how much the worst law is broken.
Real ContactSystem::off() const {
  Real most = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Real wanted = std::max(impulse_[i] - mass(i) * rate_[i], Real{0});
    most = std::max(most, std::abs(impulse_[i] - wanted) / mass(i));
  }
  for (const Friction& friction : frictions_) {
    const std::size_t i = friction.unknown;
    if (i == none || !(mass(i) > 0)) continue;
    const Real bound = friction.row->friction() * load(friction);
    const Real wanted = clamp(impulse_[i] - mass(i) * rate_[i], -bound, bound);
    most = std::max(most, std::abs(impulse_[i] - wanted) / mass(i));
  }
  return most;
}

/// Which points press and which contacts slip, by their present impulses and rates.
void ContactSystem::choose() {
  for (Friction& friction : frictions_) {
    Real load = 0;
    for (std::size_t i = friction.first; i < friction.first + friction.count; ++i) {
      const Real wanted = impulse_[i] - mass(i) * rate_[i];
      points_[i].presses = wanted > 0;
      load += std::max(wanted, Real{0});
    }
    if (friction.unknown == none) continue;
    const Real wanted = impulse_[friction.unknown] - mass(friction.unknown) * rate_[friction.unknown];
    if (load == 0) {
      friction.hold = Hold::none;
    } else if (std::abs(wanted) <= friction.row->friction() * load) {
      friction.hold = Hold::sticks;
    } else {
      friction.hold = wanted > 0 ? Hold::forward : Hold::backward;
    }
  }
}

/// The friction of a contact that slips for a unit of its load.
Real ContactSystem::slope(const Friction& friction) const {
  if (friction.hold == Hold::forward) return friction.row->friction();
  return friction.hold == Hold::backward ? -friction.row->friction() : Real{0};
}

void ContactSystem::change(std::size_t unknown, Real by) {
  if (by == 0) return;
  impulse_[unknown] += by;
  for (std::size_t i = 0; i < rate_.size(); ++i) rate_[i] += k(i, unknown) * by;
  if (unknown < points_.size()) rate_[unknown] += points_[unknown].give * by;
}

/// Solves the linear system of those that press and slip now.
bool ContactSystem::newton() {
  solved_.clear();
  for (const Friction& friction : frictions_) {
    Real load = 0;
    for (std::size_t i = friction.first; i < friction.first + friction.count; ++i) {
      if (points_[i].presses) {
        solved_.push_back({i, friction.unknown, slope(friction)});
        load += impulse_[i];
      } else {
        change(i, -impulse_[i]);
      }
    }
    if (friction.unknown == none) continue;
    if (friction.hold == Hold::sticks) {
      solved_.push_back({friction.unknown});
    } else {
      change(friction.unknown, slope(friction) * load - impulse_[friction.unknown]);
    }
  }
  const std::size_t n = solved_.size();
  matrix_.resize(n * n);
  right_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = solved_[i].unknown;
    right_[i] = -rate_[row];
    for (std::size_t j = 0; j < n; ++j) {
      const Solved& column = solved_[j];
      matrix_[i * n + j] = k(row, column.unknown);
      if (column.slope != 0) matrix_[i * n + j] += column.slope * k(row, column.slips);
    }
    matrix_[i * n + i] += least_change * k(row, row) + (row < points_.size() ? points_[row].give : Real{0});
  }
  if (!eliminate(matrix_, right_)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    change(solved_[i].unknown, right_[i]);
    if (solved_[i].slope != 0) change(solved_[i].slips, solved_[i].slope * right_[i]);
  }
  return true;
}

void ContactSystem::apply(BodySet& bodies) const {
  for (const Friction& friction : frictions_) {
    ImpactRow& row = *friction.row;
    Velocity& a = bodies.velocity[row.a];
    Velocity& b = bodies.velocity[row.b];
    ContactFrame frame(row, a, b);
    for (std::size_t i = 0; i < friction.count; ++i) {
      RowPoint& p = *points_[friction.first + i].row;
      apply_accumulated(row, p, frame, std::max(impulse_[friction.first + i], Real{0}));
      if (friction.unknown == none) continue;
      const Real most = row.friction() * p.normal_impulse;
      const Real held = friction.hold == Hold::sticks
                            ? clamp(share(friction, i) * impulse_[friction.unknown], -most, most)
                            : std::copysign(most, slope(friction));
      frame.push_tangent(row, p, held);
      p.tangent_impulse = held;
    }
    frame.write_back(row, a, b);
  }
}

bool ContactSystem::solve(const Island& island, Stage stage, BodySet& bodies, const std::vector<Motion>& motion) {
  before_.clear();
  for (const std::uint32_t body : island.bodies) before_.push_back(bodies.velocity[body]);
  const auto take_back = [&] {
    for (std::size_t i = 0; i < before_.size(); ++i) bodies.velocity[island.bodies[i]] = before_[i];
  };
  constexpr int most_rounds = 20;
  const bool listed = list(island, stage, bodies, motion);
  for (int round = 0; listed && round < most_rounds; ++round) {
    if (place_friction() || round == 0) measure(bodies);
    if (off() <= may_remain * speed_) {
      if (round == 0) take_back();
      if (round > 0) apply(bodies);
      return true;
    }
    choose();
    if (!newton()) break;
  }
  take_back();
  return false;
}

}  // namespace impulse::inline IMPULSE_PRECISION
