#include "solver/constraint_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/lcp.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Of the largest term of a rate, by what it is rounded here, whatever impulses it is the sum of.
constexpr double sums_round_by = 64 * std::numeric_limits<double>::epsilon();
/// Of the same without impulses, by how much rows may contradict each other.
constexpr double rows_round_by = 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());
/// By how much laws may be broken: less than the velocities are rounded by.
constexpr double enough_of = std::max(sums_round_by, static_cast<double>(std::numeric_limits<Real>::epsilon()) / 64);
constexpr double pivots_round_by = std::max(rows_round_by, lcp_round_off);

}  // namespace

void ConstraintSystem::clear() {
  for (const std::uint32_t body : bodies_) number_of_[body] = no_number;
  bodies_.clear();
  ends_.clear();
  rows_.clear();
  state_.clear();
  factored_ = begun_ = yielded_ = joined_ = false;
}

std::uint32_t ConstraintSystem::add(const Constraint& constraint) {
  rows_.push_back(constraint);
  joined_ = joined_ || constraint.law == Law::holds;
  ends_.push_back({number_of(constraint.a), number_of(constraint.b)});
  return static_cast<std::uint32_t>(rows_.size() - 1);
}

std::uint32_t ConstraintSystem::number_of(std::uint32_t body) {
  if (body >= number_of_.size()) number_of_.resize(body + 1, no_number);
  if (number_of_[body] == no_number) {
    number_of_[body] = static_cast<std::uint32_t>(bodies_.size());
    bodies_.push_back(body);
  }
  return number_of_[body];
}

double ConstraintSystem::rate(std::size_t i) const {
  const double yields = yield_ > 0 && mass_[i] > 0 ? yield_ / mass_[i] * rows_[i].impulse : 0;
  return speed(rows_[i], now_[ends_[i].a], now_[ends_[i].b]) + rows_[i].bias + yields;
}

void ConstraintSystem::change(std::size_t i, double by) {
  const Constraint& row = rows_[i];
  if (pushable(row.mass_a)) {
    Precise& a = now_[ends_[i].a];
    a.x -= double{row.mass_a.m} * by * double{row.axis.x};
    a.y -= double{row.mass_a.m} * by * double{row.axis.y};
    a.w -= double{row.mass_a.i} * by * double{row.arm_a};
  }
  if (pushable(row.mass_b)) {
    Precise& b = now_[ends_[i].b];
    b.x += double{row.mass_b.m} * by * double{row.axis.x};
    b.y += double{row.mass_b.m} * by * double{row.axis.y};
    b.w += double{row.mass_b.i} * by * double{row.arm_b};
  }
}

void ConstraintSystem::give(std::size_t i, double by) {
  if (by == 0) return;
  rows_[i].impulse += by;
  change(i, by);
}

double ConstraintSystem::load(const Constraint& friction) const {
  double sum = 0;
  for (std::uint32_t p = friction.first; p < friction.first + friction.count; ++p) sum += rows_[p].impulse;
  return std::max(sum, 0.);
}

ConstraintSystem::Work ConstraintSystem::work() const {
  Work work;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (row.law == Law::holds) continue;  // mends what joints were off, by which it may do some
    const Ends& ends = ends_[i];
    const double before = speed(row, start_[ends.a], start_[ends.b]);
    const double impulse = row.impulse - row.given;
    work.done += impulse * (before + speed(row, now_[ends.a], now_[ends.b])) / 2;
    work.rounding += std::abs(impulse) * (rows_round_by * std::abs(before) + contradiction());
  }
  return work;
}

void ConstraintSystem::weigh(std::size_t i) {
  const Constraint& row = rows_[i];
  const double own = response(row, row);
  mass_[i] = own > 0 && !row.fixed ? 1 / own : 0.;
}

/// How a constraint acts that has this impulse, up to a fraction by which it is rounded. What is at its bound stays
/// there: a pile that slides goes on to slide.
ConstraintSystem::State ConstraintSystem::guessed_state(const Constraint& row, double rounding) const {
  if (row.law == Law::holds) return State::holds;
  if (row.impulse == 0) return State::off;
  if (row.law == Law::pushes) return State::holds;
  const double most = row.law == Law::rubs ? row.friction * load(row) : row.most;
  if (std::abs(row.impulse) < (1 - rounding) * most) return State::holds;
  return row.impulse > 0 ? State::forward : State::backward;
}

/// In the first call notes the velocities and applies the guesses.
void ConstraintSystem::begin(const std::vector<Velocity>& velocity) {
  if (!begun_) {
    now_.clear();
    for (const std::uint32_t body : bodies_) now_.emplace_back(velocity[body]);
    start_ = now_;
  }
  mass_.resize(rows_.size());
  scale_ = pushed_ = 0;
  if (!begun_) fastest_ = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    weigh(i);
    const double inverse = mass_[i] > 0 ? 1 / mass_[i] : 0;
    const Precise& a = now_[ends_[i].a];
    const Precise& b = now_[ends_[i].b];
    const bool turns = row.axis == Vec2{};
    const double moves = turns ? 0 : std::sqrt(a.x * a.x + a.y * a.y) + std::sqrt(b.x * b.x + b.y * b.y);
    const double terms = moves + std::abs(a.w * double{row.arm_a}) + std::abs(b.w * double{row.arm_b});
    // Of a gap that is open, only as much as closes counts.
    const double bias = row.law == Law::pushes ? std::max(-row.bias, 0.) : std::abs(row.bias);
    if (!begun_) fastest_ = std::max({fastest_, terms, bias});
    scale_ = std::max({scale_, terms, bias});
    pushed_ = std::max(pushed_, std::abs(row.impulse) * inverse);
  }
  if (!begun_) {
    begun_ = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (std::abs(rows_[i].impulse) <= enough() * mass_[i]) rows_[i].impulse = 0;
      if (rows_[i].impulse != rows_[i].given) change(i, rows_[i].impulse - rows_[i].given);
    }
  }
  if (state_.size() == rows_.size()) return;
  state_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    state_[i] = guessed_state(rows_[i], enough_of);
  }
  factored_ = false;
}

/// Bodies that nothing changes are not written: those that cannot be pushed may belong to other islands too.
void ConstraintSystem::tell(std::vector<Velocity>& velocity) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Velocity& to = velocity[bodies_[i]];
    const Vec2 v{static_cast<Real>(now_[i].x), static_cast<Real>(now_[i].y)};
    const Real w = static_cast<Real>(now_[i].w);
    if (to.v == v && to.w == w) continue;
    to.v = v;
    to.w = w;
  }
}

/// The impulse that would bring this rate alone to 0, within the constraint's bounds.
double ConstraintSystem::wanted(std::size_t i, double rate) const {
  const Constraint& row = rows_[i];
  const double free = row.impulse - mass_[i] * rate;
  switch (row.law) {
    case Law::holds:
      return free;
    case Law::pushes:
      return std::max(free, 0.);
    case Law::drives:
      return std::clamp(free, -row.most, row.most);
    case Law::rubs:
      break;
  }
  const double most = row.friction * load(row);
  return std::clamp(free, -most, most);
}

/// m/s, by how much the worst law is broken; notes all rates.
double ConstraintSystem::broken_by() {
  rates_.assign(rows_.size(), 0);
  double most = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!(mass_[i] > 0)) continue;
    rates_[i] = rate(i);
    most = std::max(most, std::abs(rows_[i].impulse - wanted(i, rates_[i])) / mass_[i]);
  }
  return most;
}

/// Which constraints act, by their present impulses and the rates that broken_by() has noted.
void ConstraintSystem::choose() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (!(mass_[i] > 0)) {
      state_[i] = State::off;
      continue;
    }
    const double free = row.impulse - mass_[i] * rates_[i];
    double most = row.most;
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
        double sum = 0;
        bool any = false;
        for (std::uint32_t p = row.first; p < row.first + row.count; ++p) {
          if (!bears(p)) continue;
          any = true;
          sum += std::max(rows_[p].impulse - mass_[p] * rates_[p], 0.);
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
void ConstraintSystem::place_friction() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Constraint& row = rows_[i];
    if (row.law != Law::rubs) continue;
    bool any = false;
    for (std::uint32_t p = 0; p < row.count; ++p) any = any || bears(row.first + p);
    Real arm_a = 0;
    Real arm_b = 0;
    double bias = 0;
    Real points = 0;
    for (std::uint32_t p = 0; p < row.count; ++p) {
      if (any && !bears(row.first + p)) continue;
      arm_a += row.point_a[p];
      arm_b += row.point_b[p];
      bias += row.point_bias[p];
      ++points;
    }
    row.bias = bias / double{points};
    arm_a /= points;
    arm_b /= points;
    if (arm_a == row.arm_a && arm_b == row.arm_b) continue;
    change(i, row.given - row.impulse);
    row.arm_a = arm_a;
    row.arm_b = arm_b;
    change(i, row.impulse - row.given);
    weigh(i);
    factored_ = false;
  }
}

/// Solves the linear system of those that act now. False if it is singular.
bool ConstraintSystem::newton() {
  place_friction();
  if (!factored_ || last_ != state_) {
    factored_ = factor();
    last_ = state_;
    if (!factored_) return false;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (state_[i] == State::holds || row.fixed) continue;
    double impulse = 0;
    if (state_[i] != State::off) impulse = row.law == Law::rubs ? row.friction * load(row) : row.most;
    give(i, (state_[i] == State::backward ? -impulse : impulse) - row.impulse);
  }
  right_.clear();
  for (const std::uint32_t i : free_) right_.push_back(-rate(i));
  substitute();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    give(free_[i], right_[i]);
    if (slips_[i] != no_number) give(slips_[i], slope_[i] * right_[i]);
  }
  return true;
}

void ConstraintSystem::note_impulses() {
  last_impulses_.clear();
  for (const Constraint& row : rows_) last_impulses_.push_back(row.impulse);
}

void ConstraintSystem::sweep() {
  place_friction();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (mass_[i] > 0) give(i, wanted(i, rate(i)) - rows_[i].impulse);
  }
}

/// Keeps the impulses if they break laws less than those kept before.
void ConstraintSystem::keep(double broken) {
  if (!(broken < least_broken_)) return;
  least_broken_ = broken;
  best_.clear();
  for (const Constraint& row : rows_) best_.push_back(row.impulse);
}

/// The velocities at the start with all impulses since: without the rounding of those that were taken back.
void ConstraintSystem::rebuild() {
  now_ = start_;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].impulse != rows_[i].given) change(i, rows_[i].impulse - rows_[i].given);
  }
}

/// Rounds at each constraint, not by the largest of them; impulses of the size of rounding are none, and friction has
/// no part in those.
void ConstraintSystem::finish(double enough) {
  sweep();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Constraint& row = rows_[i];
    if (std::abs(row.impulse) <= enough * mass_[i]) row.impulse = 0;
    if (row.law != Law::rubs) continue;
    const double most = row.friction * load(row);
    row.impulse = std::clamp(row.impulse, -most, most);
  }
  rebuild();
}

/// m/s, by how much laws may be broken.
double ConstraintSystem::enough() const { return std::max(enough_of * scale_, sums_round_off()); }

/// m/s, by what rates are rounded as sums of what impulses change; of masses so far apart that it would be felt, only
/// what yielding laws may be broken by.
double ConstraintSystem::sums_round_off() const { return std::min(sums_round_by * pushed_, most_yield * fastest_); }

/// m/s, by how much rows may contradict each other.
double ConstraintSystem::contradiction() const { return std::max(rows_round_by * scale_, sums_round_off()); }

void ConstraintSystem::be_firm(double share) {
  factored_ = factored_ && share == firm_;
  firm_ = share;
}

/// Newton's iteration until no law is broken by more than enough, or, where rows contradict each other, until it no
/// longer helps. False, with the best impulses, if there are laws.
bool ConstraintSystem::iterate(double enough) {
  constexpr int rounds = 16;
  least_broken_ = std::numeric_limits<double>::infinity();
  in_circles_ = false;
  be_firm(1);
  double before = least_broken_;
  for (int round = 0;; ++round) {
    const double broken = broken_by();
    if (broken <= enough) return true;
    if (least_broken_ <= contradiction() && broken > least_broken_ / 2) break;
    keep(broken);
    if (round == rounds) break;
    if (broken <= wild * before || !back_to_first_bound()) {
      if (round > 0 || !factored_) choose();
      in_circles_ = last_ != state_;
      const bool slow = round > 0 && !in_circles_ && broken > slowly * before && broken > contradiction();
      const bool contradicts = joined_ && broken <= most_yield * fastest_;
      if (slow && !contradicts && firm_ * least_compliance > firmest) be_firm(firmer * firm_);
      note_impulses();
    }
    before = broken;
    if (!newton()) break;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].impulse = best_[i];
  rebuild();
  return least_broken_ <= contradiction();
}

/// Friction that a guess puts beside its bound by rounding is at its bound.
void ConstraintSystem::slide_on_the_cone(double enough) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (row.law != Law::rubs || !(mass_[i] > 0)) continue;
    const double most = row.friction * load(row);
    const double short_of = most - std::abs(row.impulse);
    if (std::abs(short_of) <= enough * mass_[i]) give(i, std::copysign(most, row.impulse) - row.impulse);
  }
}

bool ConstraintSystem::solve(std::vector<Velocity>& velocity) {
  if (rows_.empty()) return true;
  begin(velocity);
  place_friction();
  const double enough = this->enough();
  bool found = broken_by() <= enough;
  if (found) {
    slide_on_the_cone(enough);
  } else {
    // Where what acts no longer changes, equations contradict each other or rounding is left: pivoting mends neither.
    found = iterate(enough) || (in_circles_ && iterate_from_pivots(enough)) ||
            least_broken_ <= std::max(pivots_round_by * scale_, lcp_round_off * pushed_);
    finish(enough);
  }
  const bool is_jammed = (!found && least_broken_ > most_yield * fastest_) || shoots();
  if (is_jammed) yield(enough);
  tell(velocity);
  return found && !is_jammed;
}

/// Whether bodies on paths, which no energy bounds, move others faster than any lever would: along normals that differ
/// by a thousandth, what presses a pile together squeezes it out a thousand times as fast.
bool ConstraintSystem::shoots() const {
  const double most = most_leverage * fastest_;
  const auto fast = [most](const Precise& v) { return v.x * v.x + v.y * v.y > most * most; };
  if (std::none_of(now_.begin(), now_.end(), fast)) return false;
  const auto on_path = [this](const InverseMass& mass, std::uint32_t body) {
    return !pushable(mass) && (now_[body].x != 0 || now_[body].y != 0 || now_[body].w != 0);
  };
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (on_path(rows_[i].mass_a, ends_[i].a) || on_path(rows_[i].mass_b, ends_[i].b)) return true;
  }
  return false;
}

/// Solves laws that all yield a little: such have a solution whatever they demand.
void ConstraintSystem::yield(double enough) {
  yielded_ = true;
  yield_ = most_yield;
  for (Constraint& row : rows_) row.impulse = row.given;
  rebuild();
  for (std::size_t i = 0; i < rows_.size(); ++i) state_[i] = guessed_state(rows_[i], enough_of);
  factored_ = false;
  if (!iterate(enough)) iterate_from_pivots(enough);
  finish(enough);
  yield_ = 0;
  factored_ = false;
}

/// The same from what acts in the solution by pivoting.
bool ConstraintSystem::iterate_from_pivots(double enough) {
  if (!pivot()) return false;
  for (std::size_t i = 0; i < rows_.size(); ++i) state_[i] = guessed_state(rows_[i], pivots_round_by);
  place_friction();
  factored_ = factor();
  last_ = state_;
  return iterate(enough);
}

void ConstraintSystem::restart(std::vector<Velocity>& velocity) {
  now_ = start_;
  tell(velocity);
  begun_ = false;
  reconsider();
}

void ConstraintSystem::undo(std::vector<Velocity>& velocity) {
  for (Constraint& row : rows_) row.impulse = row.given = 0;
  rebuild();
  tell(velocity);
  reconsider();
}

}  // namespace impulse::inline IMPULSE_PRECISION
