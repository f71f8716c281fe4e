#include "solver/constraint_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/lcp.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::uint32_t nothing_slips = ~std::uint32_t{0};

/// Of the largest term of a rate, what rounding may leave of it.
constexpr Real rates_round_by = 64 * std::numeric_limits<Real>::epsilon();
constexpr Real pivots_round_by = std::max(rates_round_by, static_cast<Real>(lcp_round_off));

}  // namespace

void ConstraintSystem::clear() {
  rows_.clear();
  state_.clear();
  factored_ = begun_ = false;
}

std::uint32_t ConstraintSystem::add(const Constraint& constraint) {
  rows_.push_back(constraint);
  return static_cast<std::uint32_t>(rows_.size() - 1);
}

Real ConstraintSystem::rate(std::size_t i, const std::vector<Velocity>& velocity) const {
  const Constraint& row = rows_[i];
  return speed(row, velocity) + row.bias;
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
    const Real impulse = row.impulse - row.given;
    work += impulse * (before + speed(row, velocity)) / 2;
    size += std::abs(impulse * before);
  }
  return work > rates_round_by * size;
}

void ConstraintSystem::weigh(std::size_t i) {
  const Constraint& row = rows_[i];
  const Real own = response<Real>(row, row);
  mass_[i] = own > 0 && !row.fixed ? 1 / own : Real{0};
}

/// How a constraint acts that has this impulse, up to a fraction by which it is rounded. What is at its bound stays
/// there: a pile that slides goes on to slide.
ConstraintSystem::State ConstraintSystem::guessed_state(const Constraint& row, Real rounding) const {
  if (row.law == Law::holds) return State::holds;
  if (row.impulse == 0) return State::off;
  if (row.law == Law::pushes) return State::holds;
  const Real most = row.law == Law::rubs ? row.friction * load(row) : row.most;
  if (std::abs(row.impulse) < (1 - rounding) * most) return State::holds;
  return row.impulse > 0 ? State::forward : State::backward;
}

/// Notes the velocities, and in the first call applies the guesses.
void ConstraintSystem::begin(std::vector<Velocity>& velocity) {
  mass_.resize(rows_.size());
  scale_ = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    weigh(i);
    const Real inverse = mass_[i] > 0 ? 1 / mass_[i] : Real{0};
    const Velocity& a = velocity[row.a];
    const Velocity& b = velocity[row.b];
    const bool turns = row.axis == Vec2{};
    const Real moves = turns ? Real{0} : length(a.v) + length(b.v);
    const Real terms = moves + std::abs(a.w * row.arm_a) + std::abs(b.w * row.arm_b);
    scale_ = std::max({scale_, terms, std::abs(row.bias), std::abs(row.impulse) * inverse});
  }
  if (!begun_) {
    begun_ = true;
    start_.clear();
    for (const Constraint& row : rows_) start_.emplace_back(velocity[row.a], velocity[row.b]);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (std::abs(rows_[i].impulse) <= rates_round_by * scale_ * mass_[i]) rows_[i].impulse = 0;
      if (rows_[i].impulse != rows_[i].given) change(i, rows_[i].impulse - rows_[i].given, velocity);
    }
  }
  if (state_.size() == rows_.size()) return;
  state_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    state_[i] = guessed_state(rows_[i], rates_round_by);
  }
  factored_ = false;
}

/// The impulse that would bring this rate alone to 0, within the constraint's bounds.
Real ConstraintSystem::wanted(std::size_t i, const std::vector<Velocity>& velocity) const {
  const Constraint& row = rows_[i];
  const Real free = row.impulse - mass_[i] * rate(i, velocity);
  switch (row.law) {
    case Law::holds:
      return free;
    case Law::pushes:
      return std::max(free, Real{0});
    case Law::drives:
      return clamp(free, -row.most, row.most);
    case Law::rubs:
      break;
  }
  const Real most = row.friction * load(row);
  return clamp(free, -most, most);
}

/// m/s, by how much the worst law is broken.
Real ConstraintSystem::broken_by(const std::vector<Velocity>& velocity) const {
  Real most = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (mass_[i] > 0) most = std::max(most, std::abs(rows_[i].impulse - wanted(i, velocity)) / mass_[i]);
  }
  return most;
}

/// Which constraints act, by their present impulses and rates.
void ConstraintSystem::choose(const std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (!(mass_[i] > 0)) {
      state_[i] = State::off;
      continue;
    }
    const Real free = row.impulse - mass_[i] * rate(i, velocity);
    Real most = row.most;
    switch (row.law) {
      case Law::holds:
        state_[i] = State::holds;
        continue;
      case Law::pushes:
        state_[i] = free > 0 ? State::holds : State::off;
        continue;
      case Law::drives:
        break;
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
          state_[i] = State::off;
          continue;
        }
        break;
      }
    }
    state_[i] = std::abs(free) <= most ? State::holds : free > 0 ? State::forward : State::backward;
  }
}

/// Whether a point of a contact bears load.
bool ConstraintSystem::bears(std::size_t point) const {
  return rows_[point].fixed ? rows_[point].impulse > 0 : state_[point] != State::off;
}

/// Lets friction act where its load does.
void ConstraintSystem::place_friction(std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Constraint& row = rows_[i];
    if (row.law != Law::rubs) continue;
    bool any = false;
    for (std::uint32_t p = 0; p < row.count; ++p) any = any || bears(row.first + p);
    Real arm_a = 0;
    Real arm_b = 0;
    Real bias = 0;
    Real points = 0;
    for (std::uint32_t p = 0; p < row.count; ++p) {
      if (any && !bears(row.first + p)) continue;
      arm_a += row.point_a[p];
      arm_b += row.point_b[p];
      bias += row.point_bias[p];
      ++points;
    }
    row.bias = bias / points;
    arm_a /= points;
    arm_b /= points;
    if (arm_a == row.arm_a && arm_b == row.arm_b) continue;
    change(i, row.given - row.impulse, velocity);
    row.arm_a = arm_a;
    row.arm_b = arm_b;
    change(i, row.impulse - row.given, velocity);
    weigh(i);
  }
}

/// The rows that are solved for, neighbours beside each other, and the friction that follows them.
void ConstraintSystem::choose_unknowns() {
  friction_of_.assign(rows_.size(), nothing_slips);
  free_.clear();
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (state_[i] == State::holds) free_.push_back(i);
    if (row.law != Law::rubs || state_[i] == State::holds || state_[i] == State::off) continue;
    for (std::uint32_t p = row.first; p < row.first + row.count; ++p) friction_of_[p] = i;
  }
  std::sort(free_.begin(), free_.end(), [this](std::uint32_t i, std::uint32_t j) {
    return rows_[i].place != rows_[j].place ? rows_[i].place < rows_[j].place : i < j;
  });
  slips_.clear();
  slope_.clear();
  for (const std::uint32_t i : free_) {
    const std::uint32_t friction = friction_of_[i];
    slips_.push_back(friction);
    slope_.push_back(friction == nothing_slips            ? Real{0}
                     : state_[friction] == State::forward ? rows_[friction].friction
                                                          : -rows_[friction].friction);
  }
}

/// How far apart unknowns are at most that act on one body.
std::size_t ConstraintSystem::bandwidth() {
  const auto each_body = [this](auto&& visit) {
    for (std::uint32_t k = 0; k < free_.size(); ++k) {
      const Constraint& row = rows_[free_[k]];
      if (pushable(row.mass_a)) visit(row.a, k);
      if (pushable(row.mass_b)) visit(row.b, k);
    }
  };
  each_body([this](std::uint32_t body, std::uint32_t) {
    if (body >= first_of_.size()) first_of_.resize(body + 1);
    first_of_[body] = nothing_slips;
  });
  std::uint32_t most = 0;
  each_body([&](std::uint32_t body, std::uint32_t k) {
    std::uint32_t& first = first_of_[body];
    if (first == nothing_slips) first = k;
    most = std::max(most, k - first);
  });
  return most;
}

/// L U of the matrix of the unknowns, by partial pivoting. False if it is singular.
bool ConstraintSystem::factor() {
  choose_unknowns();
  const std::size_t n = free_.size();
  band_ = bandwidth();
  const bool narrow = 3 * band_ + 1 < n;
  stride_ = narrow ? 3 * band_ : n;
  shift_ = narrow ? band_ : 0;
  matrix_.assign(n * (stride_ + 1) + shift_ + 1, 0);
  const auto row_at = [this](std::size_t i) { return &matrix_[i * stride_ + shift_]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Constraint& row = rows_[free_[i]];
    Real* entries = row_at(i);
    const std::size_t end = std::min(n, i + band_ + 1);
    for (std::size_t j = i > band_ ? i - band_ : 0; j < end; ++j) {
      entries[j] = response<Real>(row, rows_[free_[j]]);
      if (slips_[j] != nothing_slips) entries[j] += slope_[j] * response<Real>(row, rows_[slips_[j]]);
    }
    entries[i] += least_compliance / mass_[free_[i]];
  }
  pivot_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t below = std::min(n, k + band_ + 1);
    const std::size_t right = std::min(n, k + 2 * band_ + 1);
    std::size_t best = k;
    for (std::size_t i = k + 1; i < below; ++i) {
      if (std::abs(row_at(i)[k]) > std::abs(row_at(best)[k])) best = i;
    }
    pivot_[k] = best;
    Real* from = row_at(k);
    if (best != k) std::swap_ranges(from + k, from + right, row_at(best) + k);
    if (!(std::abs(from[k]) > 0)) return false;
    for (std::size_t i = k + 1; i < below; ++i) {
      Real* to = row_at(i);
      if (to[k] == 0) continue;
      to[k] /= from[k];
      const Real factor = to[k];
      for (std::size_t j = k + 1; j < right; ++j) to[j] -= factor * from[j];
    }
  }
  return true;
}

/// Turns the right side into the solution.
void ConstraintSystem::substitute() {
  const std::size_t n = free_.size();
  const auto row_at = [this](std::size_t i) { return &matrix_[i * stride_ + shift_]; };
  for (std::size_t k = 0; k < n; ++k) {
    std::swap(right_[k], right_[pivot_[k]]);
    const std::size_t below = std::min(n, k + band_ + 1);
    for (std::size_t i = k + 1; i < below; ++i) right_[i] -= row_at(i)[k] * right_[k];
  }
  for (std::size_t k = n; k-- > 0;) {
    const Real* entries = row_at(k);
    const std::size_t end = std::min(n, k + 2 * band_ + 1);
    for (std::size_t j = k + 1; j < end; ++j) right_[k] -= entries[j] * right_[j];
    right_[k] /= entries[k];
  }
}

/// Solves the linear system of those that act now. False if it is singular.
bool ConstraintSystem::newton(std::vector<Velocity>& velocity) {
  place_friction(velocity);
  if (!factored_ || last_ != state_) {
    factored_ = factor();
    last_ = state_;
    if (!factored_) return false;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (state_[i] == State::holds || row.fixed) continue;
    Real impulse = 0;
    if (state_[i] != State::off) impulse = row.law == Law::rubs ? row.friction * load(row) : row.most;
    give(i, (state_[i] == State::backward ? -impulse : impulse) - row.impulse, velocity);
  }
  right_.clear();
  for (const std::uint32_t i : free_) right_.push_back(-rate(i, velocity));
  substitute();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    give(free_[i], right_[i], velocity);
    if (slips_[i] != nothing_slips) give(slips_[i], slope_[i] * right_[i], velocity);
  }
  return true;
}

void ConstraintSystem::sweep(std::vector<Velocity>& velocity) {
  place_friction(velocity);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (mass_[i] > 0) give(i, wanted(i, velocity) - rows_[i].impulse, velocity);
  }
}

/// Keeps the impulses if they break laws less than those kept before.
void ConstraintSystem::keep(Real broken) {
  if (!(broken < least_broken_)) return;
  least_broken_ = broken;
  best_.clear();
  for (const Constraint& row : rows_) best_.push_back(row.impulse);
}

void ConstraintSystem::go_back(std::vector<Velocity>& velocity) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (pushable(row.mass_a)) velocity[row.a] = start_[i].first;
    if (pushable(row.mass_b)) velocity[row.b] = start_[i].second;
  }
}

/// The velocities at the start with all impulses since: without the rounding of those that were taken back.
void ConstraintSystem::rebuild(std::vector<Velocity>& velocity) {
  go_back(velocity);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].impulse != rows_[i].given) change(i, rows_[i].impulse - rows_[i].given, velocity);
  }
}

/// Rounds at each constraint, not by the largest of them; impulses of the size of rounding are none.
void ConstraintSystem::finish(Real enough, std::vector<Velocity>& velocity) {
  sweep(velocity);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Constraint& row = rows_[i];
    if (std::abs(row.impulse) <= enough * mass_[i] || (row.law == Law::rubs && load(row) == 0)) row.impulse = 0;
  }
  rebuild(velocity);
}

/// Newton's iteration until no law is broken by more than enough. False, with the best impulses, if there are laws.
bool ConstraintSystem::iterate(Real enough, std::vector<Velocity>& velocity) {
  constexpr int rounds = 16;
  least_broken_ = std::numeric_limits<Real>::infinity();
  in_circles_ = false;
  for (int round = 0;; ++round) {
    const Real broken = broken_by(velocity);
    if (broken <= enough) return true;
    keep(broken);
    if (round == rounds) break;
    if (round > 0 || !factored_) choose(velocity);
    in_circles_ = last_ != state_;
    if (!newton(velocity)) break;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].impulse = best_[i];
  rebuild(velocity);
  return false;
}

/// Friction that a guess puts beside its bound by rounding is at its bound.
void ConstraintSystem::slide_on_the_cone(Real enough, std::vector<Velocity>& velocity) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (row.law != Law::rubs || !(mass_[i] > 0)) continue;
    const Real most = row.friction * load(row);
    const Real short_of = most - std::abs(row.impulse);
    if (std::abs(short_of) <= enough * mass_[i]) give(i, std::copysign(most, row.impulse) - row.impulse, velocity);
  }
}

bool ConstraintSystem::solve(std::vector<Velocity>& velocity) {
  if (rows_.empty()) return true;
  begin(velocity);
  place_friction(velocity);
  const Real enough = rates_round_by * scale_;
  if (broken_by(velocity) <= enough) {
    slide_on_the_cone(enough, velocity);
    return true;
  }
  // Where what acts no longer changes, equations contradict each other or rounding is left: pivoting mends neither.
  const bool found = iterate(enough, velocity) || (in_circles_ && iterate_from_pivots(enough, velocity));
  finish(enough, velocity);
  return found || least_broken_ <= pivots_round_by * scale_;
}

/// The same from what acts in the solution by pivoting.
bool ConstraintSystem::iterate_from_pivots(Real enough, std::vector<Velocity>& velocity) {
  if (!pivot(velocity)) return false;
  for (std::size_t i = 0; i < rows_.size(); ++i) state_[i] = guessed_state(rows_[i], pivots_round_by);
  place_friction(velocity);
  factored_ = factor();
  last_ = state_;
  return iterate(enough, velocity);
}

void ConstraintSystem::restart(std::vector<Velocity>& velocity) {
  go_back(velocity);
  begun_ = false;
  reconsider();
}

void ConstraintSystem::undo(std::vector<Velocity>& velocity) {
  for (Constraint& row : rows_) row.impulse = row.given = 0;
  rebuild(velocity);
  reconsider();
}

}  // namespace impulse::inline IMPULSE_PRECISION
