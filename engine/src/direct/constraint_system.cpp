#include "direct/constraint_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

/// Of the largest term of a rate, what rounding may leave of it.
constexpr Real may_remain = 64 * std::numeric_limits<Real>::epsilon();

/// Compliance, as a fraction of a constraint's own inverse mass, that decides between equal ways to share a load. It
/// does not stay: what it leaves is solved in the next round.
constexpr Real least_change = static_cast<Real>(sizeof(Real) == 8 ? 1e-9 : 1e-4);

/// The change of the rate of p for a unit impulse along q, through the bodies that both act on.
Real coupling(const Constraint& p, const Constraint& q) {
  const auto through = [&](const InverseMass& mass, Real arm_p, Real arm_q) {
    return mass.m * dot(p.axis, q.axis) + mass.i * arm_p * arm_q;
  };
  Real sum = 0;
  if (p.a == q.a) sum += through(p.mass_a, p.arm_a, q.arm_a);
  if (p.b == q.b) sum += through(p.mass_b, p.arm_b, q.arm_b);
  if (p.a == q.b) sum -= through(p.mass_a, p.arm_a, q.arm_b);
  if (p.b == q.a) sum -= through(p.mass_b, p.arm_b, q.arm_a);
  return sum;
}

}  // namespace

void ConstraintSystem::clear() {
  rows_.clear();
  state_.clear();
  factored_ = false;
}

std::uint32_t ConstraintSystem::add(const Constraint& constraint) {
  rows_.push_back(constraint);
  return static_cast<std::uint32_t>(rows_.size() - 1);
}

Real ConstraintSystem::speed(const Constraint& row, const std::vector<Velocity>& velocity) {
  const Velocity& a = velocity[row.a];
  const Velocity& b = velocity[row.b];
  return dot(row.axis, b.v - a.v) + b.w * row.arm_b - a.w * row.arm_a;
}

Real ConstraintSystem::rate(std::size_t i, const std::vector<Velocity>& velocity) const {
  const Constraint& row = rows_[i];
  return speed(row, velocity) + row.bias + compliance_[i] * (row.impulse - row.given);
}

/// Bodies that cannot be pushed are not written: they may belong to other islands too.
void ConstraintSystem::change(std::size_t i, Real by, std::vector<Velocity>& velocity) const {
  const Constraint& row = rows_[i];
  if (pushable(row.mass_a)) {
    Velocity& a = velocity[row.a];
    a.v -= row.mass_a.m * by * row.axis;
    a.w -= row.mass_a.i * by * row.arm_a;
  }
  if (pushable(row.mass_b)) {
    Velocity& b = velocity[row.b];
    b.v += row.mass_b.m * by * row.axis;
    b.w += row.mass_b.i * by * row.arm_b;
  }
}

void ConstraintSystem::give(std::size_t i, Real by, std::vector<Velocity>& velocity) {
  if (by == 0) return;
  rows_[i].impulse += by;
  change(i, by, velocity);
}

Real ConstraintSystem::load(const Constraint& friction) const {
  Real sum = 0;
  for (std::uint32_t p = friction.first; p < friction.first + friction.count; ++p) sum += rows_[p].impulse;
  return std::max(sum, Real{0});
}

bool ConstraintSystem::drove(const std::vector<Velocity>& velocity) const {
  Real work = 0;
  Real size = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    const auto& [a, b] = start_[i];
    const Real before = dot(row.axis, b.v - a.v) + b.w * row.arm_b - a.w * row.arm_a;
    const Real impulse = row.impulse - given_[i];
    work += impulse * (before + speed(row, velocity)) / 2;
    size += std::abs(impulse * before);
  }
  return work > may_remain * size;
}

void ConstraintSystem::weigh(std::size_t i) {
  const Constraint& row = rows_[i];
  const Real own = coupling(row, row);
  compliance_[i] = row.compliance + soft_ * own;
  mass_[i] = own > 0 && !row.fixed ? 1 / (own + compliance_[i]) : Real{0};
}

void ConstraintSystem::prepare(const std::vector<Velocity>& velocity) {
  mass_.resize(rows_.size());
  compliance_.resize(rows_.size());
  scale_ = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    weigh(i);
    const Real inverse = mass_[i] > 0 ? 1 / mass_[i] : Real{0};
    const Velocity& a = velocity[row.a];
    const Velocity& b = velocity[row.b];
    const bool turns = row.axis == Vec2{};
    const Real terms = (turns ? Real{0} : length(a.v) + length(b.v)) + std::abs(a.w * row.arm_a) + std::abs(b.w * row.arm_b);
    scale_ = std::max({scale_, terms, std::abs(row.bias), std::abs(row.impulse) * inverse});
  }
  if (state_.size() == rows_.size()) return;
  state_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    state_[i] = rows_[i].law == Law::holds || rows_[i].acts ? State::holds : State::off;
  }
  factored_ = false;
}

/// The impulse that would bring this rate alone to 0, within the constraint's bounds.
Real ConstraintSystem::wanted(std::size_t i, const std::vector<Velocity>& velocity) const {
  const Constraint& row = rows_[i];
  const Real free = row.impulse - mass_[i] * rate(i, velocity);
  switch (row.law) {
    case Law::holds: return free;
    case Law::pushes: return std::max(free, Real{0});
    case Law::drives: return clamp(free, -row.most, row.most);
    case Law::rubs: break;
  }
  const Real most = row.friction * load(row);
  return clamp(free, -most, most);
}

/// m/s, by how much the worst law is broken.
Real ConstraintSystem::off(const std::vector<Velocity>& velocity) const {
  Real most = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (mass_[i] > 0) most = std::max(most, std::abs(rows_[i].impulse - wanted(i, velocity)) / mass_[i]);
  }
  return most;
}

/// Which constraints act, by their present impulses and rates. Returns whether any state changed.
bool ConstraintSystem::choose(const std::vector<Velocity>& velocity) {
  bool changed = false;
  const auto set = [&](std::size_t i, State state) {
    changed = changed || state_[i] != state;
    state_[i] = state;
  };
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (!(mass_[i] > 0)) {
      set(i, State::off);
      continue;
    }
    const Real free = row.impulse - mass_[i] * rate(i, velocity);
    Real most = row.most;
    switch (row.law) {
      case Law::holds: set(i, State::holds); continue;
      case Law::pushes: set(i, free > 0 ? State::holds : State::off); continue;
      case Law::drives: break;
      case Law::rubs: {
        // Its points stand before it.
        Real sum = 0;
        bool any = false;
        for (std::uint32_t p = row.first; p < row.first + row.count; ++p) {
          if (!bears(p)) continue;
          any = true;
          sum += std::max(rows_[p].impulse - mass_[p] * rate(p, velocity), Real{0});
        }
        most = row.friction * sum;
        if (!any) {
          set(i, State::off);
          continue;
        }
        break;
      }
    }
    set(i, std::abs(free) <= most ? State::holds : free > 0 ? State::forward : State::backward);
  }
  return changed;
}

/// Whether a point of a contact bears load.
bool ConstraintSystem::bears(std::size_t point) const {
  return rows_[point].fixed ? rows_[point].impulse > 0 : state_[point] != State::off;
}

/// Lets friction act where its load does.
void ConstraintSystem::place_friction(std::size_t i, std::vector<Velocity>& velocity) {
  Constraint& row = rows_[i];
  Real arm_a = 0;
  Real arm_b = 0;
  Real bias = 0;
  Real bearing = 0;
  const auto add = [&](std::uint32_t p) {
    arm_a += row.point_a[p];
    arm_b += row.point_b[p];
    bias += row.point_bias[p];
    ++bearing;
  };
  for (std::uint32_t p = 0; p < row.count; ++p) {
    if (bears(row.first + p)) add(p);
  }
  if (bearing == 0) {
    for (std::uint32_t p = 0; p < row.count; ++p) add(p);
  }
  arm_a /= bearing;
  arm_b /= bearing;
  row.bias = bias / bearing;
  if (arm_a == row.arm_a && arm_b == row.arm_b) return;
  change(i, row.given - row.impulse, velocity);
  row.arm_a = arm_a;
  row.arm_b = arm_b;
  change(i, row.impulse - row.given, velocity);
  weigh(i);
}

/// L U of the matrix of those that are solved for, by partial pivoting. False if it is singular.
bool ConstraintSystem::factor() {
  free_.clear();
  slips_.clear();
  slope_.clear();
  std::vector<std::uint32_t> friction_of(rows_.size(), none);
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (row.law != Law::rubs || state_[i] == State::holds || state_[i] == State::off) continue;
    for (std::uint32_t p = row.first; p < row.first + row.count; ++p) friction_of[p] = i;
  }
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    if (state_[i] != State::holds) continue;
    free_.push_back(i);
    const std::uint32_t friction = rows_[i].law == Law::pushes ? friction_of[i] : none;
    slips_.push_back(friction);
    slope_.push_back(friction == none                          ? Real{0}
                     : state_[friction] == State::forward ? rows_[friction].friction
                                                          : -rows_[friction].friction);
  }
  const std::size_t n = free_.size();
  matrix_.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Constraint& row = rows_[free_[i]];
    for (std::size_t j = 0; j < n; ++j) {
      Real k = coupling(row, rows_[free_[j]]);
      if (slips_[j] != none) k += slope_[j] * coupling(row, rows_[slips_[j]]);
      matrix_[i * n + j] = k;
    }
    matrix_[i * n + i] += compliance_[free_[i]] + least_change / mass_[free_[i]];
  }
  pivot_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(matrix_[i * n + k]) > std::abs(matrix_[best * n + k])) best = i;
    }
    pivot_[k] = best;
    if (!(std::abs(matrix_[best * n + k]) > 0)) return false;
    if (best != k) {
      std::swap_ranges(matrix_.begin() + static_cast<std::ptrdiff_t>(k * n),
                       matrix_.begin() + static_cast<std::ptrdiff_t>(k * n + n),
                       matrix_.begin() + static_cast<std::ptrdiff_t>(best * n));
    }
    const Real* from = &matrix_[k * n];
    for (std::size_t i = k + 1; i < n; ++i) {
      Real* to = &matrix_[i * n];
      if (to[k] == 0) continue;
      to[k] /= from[k];
      for (std::size_t j = k + 1; j < n; ++j) to[j] -= to[k] * from[j];
    }
  }
  return true;
}

/// Solves the linear system of those that act now. False if it is singular.
bool ConstraintSystem::newton(std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].law == Law::rubs) place_friction(i, velocity);
  }
  if (!factored_ || last_ != state_) {
    factored_ = factor();
    last_ = state_;
    if (!factored_) return false;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (state_[i] == State::holds || row.fixed) continue;
    if (state_[i] == State::off) {
      give(i, -row.impulse, velocity);
      continue;
    }
    const Real most = row.law == Law::rubs ? row.friction * load(row) : row.most;
    give(i, (state_[i] == State::forward ? most : -most) - row.impulse, velocity);
  }
  const std::size_t n = free_.size();
  right_.resize(n);
  for (std::size_t i = 0; i < n; ++i) right_[i] = -rate(free_[i], velocity);
  for (std::size_t k = 0; k < n; ++k) std::swap(right_[k], right_[pivot_[k]]);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) right_[i] -= matrix_[i * n + k] * right_[k];
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right_[k] -= matrix_[k * n + j] * right_[j];
    right_[k] /= matrix_[k * n + k];
  }
  for (std::size_t i = 0; i < n; ++i) {
    give(free_[i], right_[i], velocity);
    if (slips_[i] != none) give(slips_[i], slope_[i] * right_[i], velocity);
  }
  return true;
}

void ConstraintSystem::sweep(std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].law == Law::rubs) place_friction(i, velocity);
    if (mass_[i] > 0) give(i, wanted(i, velocity) - rows_[i].impulse, velocity);
  }
}

/// Keeps the impulses if they break laws less than those kept before.
void ConstraintSystem::keep(Real off) {
  if (!(off < best_off_)) return;
  best_off_ = off;
  best_.clear();
  for (const Constraint& row : rows_) best_.push_back(row.impulse);
}

/// Goes back to the best impulses.
void ConstraintSystem::restore(std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].impulse = best_[i];
  rebuild(velocity);
}

/// The velocities at the start with all impulses since: without the rounding of those that were taken back.
void ConstraintSystem::rebuild(std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (pushable(row.mass_a)) velocity[row.a] = start_[i].first;
    if (pushable(row.mass_b)) velocity[row.b] = start_[i].second;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].impulse != given_[i]) change(i, rows_[i].impulse - given_[i], velocity);
  }
}

bool ConstraintSystem::solve(std::vector<Velocity>& velocity) {
  if (rows_.empty()) return true;
  soft_ = 0;
  prepare(velocity);
  note_start(velocity);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].law == Law::rubs) place_friction(i, velocity);
  }
  const Real enough = may_remain * scale_;
  if (off(velocity) <= enough) return true;
  constexpr int rounds = 16;
  constexpr int sweeps = 15;
  for (const double soft : {0., 1e-6, 1e-4, 1e-2}) {
    if (soft > 0) {
      soft_ = static_cast<Real>(soft);
      factored_ = false;
      for (std::size_t i = 0; i < rows_.size(); ++i) weigh(i);
      for (int i = 0; i < sweeps; ++i) sweep(velocity);
    }
    best_off_ = std::numeric_limits<Real>::infinity();
    keep(off(velocity));
    for (int round = 0; round < rounds; ++round) {
      if (round > 0 || !factored_) choose(velocity);
      if (!newton(velocity)) break;
      const Real now = off(velocity);
      if (now <= enough) {
        sweep(velocity);  // rounds at each constraint, not by the largest of them
        rebuild(velocity);
        return soft == 0;
      }
      keep(now);
    }
    restore(velocity);
  }
  for (int i = 0; i < sweeps; ++i) sweep(velocity);
  rebuild(velocity);
  return false;
}

void ConstraintSystem::note_start(const std::vector<Velocity>& velocity) {
  given_.clear();
  start_.clear();
  for (const Constraint& row : rows_) {
    given_.push_back(row.impulse);
    start_.emplace_back(velocity[row.a], velocity[row.b]);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
