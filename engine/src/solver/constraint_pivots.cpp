#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solver/constraint_system.h"
#include "solver/lcp.h"

/// Where Newton's method alone finds nothing: laws that contradict each other, and where it goes in circles, the same
/// laws as a linear complementarity problem.
namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// An unknown of the problem, never negative: an impulse along an axis or against it; or how fast a friction or a motor
/// at its bound is overcome.
struct Unknown {
  enum class Kind : std::uint8_t { forward, backward, overcome } kind = Kind::forward;
  std::uint32_t row = 0;
  double sign() const { return kind == Kind::backward ? -1 : 1; }
};

}  // namespace

/// Where rows contradict each other, what holds bears a multiple of what anything could: goes back on the way of the
/// last step to where the first impulse is at its bound, and leaves it there. False, with nothing changed, if none is.
bool ConstraintSystem::back_to_first_bound() {
  double first = 1;  // share of the step
  std::size_t bound = 0;
  State at = State::holds;
  const auto consider = [&](std::size_t i, double room, double left, State state) {
    const double share = std::max(room, 0.) / (room - left);
    if (left >= 0 || !(share < first)) return;
    first = share;
    bound = i;
    at = state;
  };
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (state_[i] != State::holds || row.law == Law::holds || row.fixed) continue;
    const double before = last_impulses_[i];
    if (row.law == Law::pushes) {
      consider(i, before, row.impulse, State::off);
      continue;
    }
    double most = row.most;
    double most_before = row.most;
    if (row.law == Law::rubs) {
      most = most_before = 0;
      for (std::uint32_t p = row.first; p < row.first + row.count; ++p) {
        most += row.friction * rows_[p].impulse;
        most_before += row.friction * last_impulses_[p];
      }
    }
    consider(i, most_before - before, most - row.impulse, State::forward);
    consider(i, most_before + before, most + row.impulse, State::backward);
  }
  if (at == State::holds) return false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].impulse = last_impulses_[i] + first * (rows_[i].impulse - last_impulses_[i]);
  }
  rebuild();
  state_[bound] = at;
  return true;
}

/// The rates of all rows for unit impulses, and last for none, row by row; equations of joints are solved for their own
/// impulses and left out of what others do.
std::vector<double> ConstraintSystem::rates_without_equations() const {
  const std::size_t n = rows_.size();
  const std::size_t width = n + 1;
  std::vector<double> rates(n * width, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(mass_[i] > 0)) continue;
    for (std::size_t j = 0; j < n; ++j) {
      if (mass_[j] > 0) rates[i * width + j] = response(rows_[i], rows_[j]);
    }
    rates[i * width + i] += yield_ / mass_[i];
    rates[i * width + n] = rate(i);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (rows_[k].law != Law::holds || !(mass_[k] > 0)) continue;
    const double* by = rates.data() + k * width;
    const double own = by[k];
    if (own * mass_[k] <= lcp_round_off) continue;  // follows from the others
    for (std::size_t i = 0; i < n; ++i) {
      double* to = rates.data() + i * width;
      const double factor = to[k] / own;
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < width; ++j) to[j] -= factor * by[j];
    }
  }
  return rates;
}

/// D. E. Stewart and J. C. Trinkle, An implicit time-stepping scheme for rigid body dynamics with inelastic collisions
/// and Coulomb friction, Int. J. Numer. Methods Eng. 39 (1996), in the plane, where it is exact. With j = f - b for
/// what acts both ways, and s >= 0 how fast its bound is overcome,
///
///   f >= 0,  w + s >= 0,   b >= 0,  s - w >= 0,   most - f - b >= 0,  s >= 0,   one of each pair 0.
///
/// Friction acts where it was placed last. Left out is what bears nothing now and closes neither now nor without
/// impulses: most of the contacts of a few bodies with many shapes. False, with nothing changed, if pivoting finds no
/// solution.
bool ConstraintSystem::pivot() {
  using Kind = Unknown::Kind;
  const auto parts = [this](std::size_t i) {
    return rows_[i].law == Law::pushes && mass_[i] > 0 && rate(i) > fastest_;
  };
  std::vector<Unknown> unknowns;
  std::vector<double> before;
  std::vector<std::uint8_t> idle;
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    before.push_back(rows_[i].impulse);
    idle.push_back(rows_[i].impulse == 0 && parts(i) ? 1 : 0);
  }
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    if (mass_[i] > 0) rows_[i].impulse = 0;
  }
  rebuild();
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const Constraint& row = rows_[i];
    if (row.law == Law::pushes && !parts(i)) idle[i] = 0;
    if (row.law == Law::rubs) {  // its points stand before it
      const auto first = idle.begin() + row.first;
      idle[i] = std::all_of(first, first + row.count, [](std::uint8_t point) { return point != 0; }) ? 1 : 0;
    }
    if (!(mass_[i] > 0) || idle[i] != 0 || row.law == Law::holds) continue;
    unknowns.push_back({Kind::forward, i});
    if (rows_[i].law == Law::pushes) continue;
    unknowns.push_back({Kind::backward, i});
    unknowns.push_back({Kind::overcome, i});
  }

  const std::vector<double> rates = rates_without_equations();
  const std::size_t n = unknowns.size();
  std::vector<double> m(n * n, 0);
  std::vector<double> q(n, 0);
  const auto coupling = [&](const Unknown& of, const Unknown& by) -> double {
    const Constraint& row = rows_[of.row];
    if (of.kind != Kind::overcome && by.kind != Kind::overcome) {
      return of.sign() * by.sign() * rates[of.row * (rows_.size() + 1) + by.row];
    }
    if (of.kind != Kind::overcome) return of.row == by.row ? 1 : 0;
    if (by.kind == Kind::overcome) return 0;
    if (of.row == by.row) return -1;
    const bool bears = row.law == Law::rubs && by.row >= row.first && by.row < row.first + row.count;
    return bears ? double{row.friction} : 0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Unknown& of = unknowns[i];
    const Constraint& row = rows_[of.row];
    for (std::size_t j = 0; j < n; ++j) m[i * n + j] = coupling(of, unknowns[j]);
    if (of.kind != Kind::overcome) {
      q[i] = of.sign() * rates[of.row * (rows_.size() + 1) + rows_.size()];
    } else {  // with the load of points whose impulses are fixed
      q[i] = row.law == Law::rubs ? double{row.friction} * load(row) : row.most;
    }
  }

  const std::optional<std::vector<double>> solution = solve_lcp(m, q);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!solution || rows_[i].law == Law::holds) rows_[i].impulse = before[i];
  }
  for (std::size_t i = 0; solution && i < n; ++i) {
    const Unknown& of = unknowns[i];
    if (of.kind != Kind::overcome) rows_[of.row].impulse += of.sign() * (*solution)[i];
  }
  rebuild();
  return solution.has_value();
}

}  // namespace impulse::inline IMPULSE_PRECISION
