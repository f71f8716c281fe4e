#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "solver/constraint_system.h"

/// The linear system of the constraints that act: neighbours beside each other, so that its matrix is a band.
namespace impulse::inline IMPULSE_PRECISION {

/// The rows that are solved for, neighbours beside each other, and the friction that follows them.
void ConstraintSystem::choose_unknowns() {
  friction_of_.assign(rows_.size(), no_number);
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
    slope_.push_back(friction == no_number                ? 0.
                     : state_[friction] == State::forward ? rows_[friction].friction
                                                          : -rows_[friction].friction);
  }
}

/// Lists the unknowns that act on each body that can be pushed; in `band_`, how far apart they are at most.
void ConstraintSystem::list_by_body() {
  const auto visit = [this](std::uint32_t k, const auto& list) {
    const Constraint& row = rows_[free_[k]];
    const Ends& ends = ends_[free_[k]];
    if (pushable(row.mass_a)) list(ends.a);
    if (pushable(row.mass_b)) list(ends.b);
  };
  const auto count = static_cast<std::uint32_t>(free_.size());
  first_on_.assign(bodies_.size() + 1, 0);
  for (std::uint32_t k = 0; k < count; ++k) {
    visit(k, [this](std::uint32_t body) { ++first_on_[body + 1]; });
  }
  for (std::size_t body = 0; body < bodies_.size(); ++body) first_on_[body + 1] += first_on_[body];
  on_body_.resize(first_on_.back());
  next_on_ = first_on_;
  for (std::uint32_t k = 0; k < count; ++k) {
    visit(k, [&](std::uint32_t body) { on_body_[next_on_[body]++] = k; });
  }
  band_ = 0;
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    if (first_on_[body] == first_on_[body + 1]) continue;
    band_ = std::max<std::size_t>(band_, on_body_[first_on_[body + 1] - 1] - on_body_[first_on_[body]]);
  }
}

/// L U of the matrix of the unknowns, by partial pivoting. False if it is singular.
bool ConstraintSystem::factor() {
  choose_unknowns();
  const std::size_t n = free_.size();
  list_by_body();
  const bool narrow = 3 * band_ + 1 < n;
  stride_ = narrow ? 3 * band_ : n;
  shift_ = narrow ? band_ : 0;
  matrix_.assign(n * (stride_ + 1) + shift_ + 1, 0);
  const auto row_at = [this](std::size_t i) { return &matrix_[i * stride_ + shift_]; };
  last_in_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Constraint& row = rows_[free_[i]];
    last_in_[i] = i;
    double* entries = row_at(i);
    const auto couple = [&](std::uint32_t body) {
      for (std::uint32_t k = first_on_[body]; k < first_on_[body + 1]; ++k) {
        const std::uint32_t j = on_body_[k];
        entries[j] = response(row, rows_[free_[j]]);
        if (slips_[j] != no_number) entries[j] += slope_[j] * response(row, rows_[slips_[j]]);
        last_in_[i] = std::max(last_in_[i], j);
      }
    };
    couple(ends_[free_[i]].a);
    couple(ends_[free_[i]].b);
    const double least = row.law == Law::holds ? least_of_equations : joined_ ? least_of_joined : least_compliance;
    entries[i] += (firm_ * least + yield_) / mass_[free_[i]];
  }
  pivot_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t below = std::min(n, k + band_ + 1);
    std::size_t best = k;
    for (std::size_t i = k + 1; i < below; ++i) {
      if (std::abs(row_at(i)[k]) > std::abs(row_at(best)[k])) best = i;
    }
    pivot_[k] = best;
    double* from = row_at(k);
    if (best != k) {
      std::swap_ranges(from + k, from + std::max(last_in_[k], last_in_[best]) + 1, row_at(best) + k);
      std::swap(last_in_[k], last_in_[best]);
    }
    if (!(std::abs(from[k]) > 0)) return false;
    for (std::size_t i = k + 1; i < below; ++i) {
      double* to = row_at(i);
      if (to[k] == 0) continue;
      to[k] /= from[k];
      const double factor = to[k];
      for (std::size_t j = k + 1; j <= last_in_[k]; ++j) to[j] -= factor * from[j];
      last_in_[i] = std::max(last_in_[i], last_in_[k]);
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
    const double* entries = row_at(k);
    for (std::size_t j = k + 1; j <= last_in_[k]; ++j) right_[k] -= entries[j] * right_[j];
    right_[k] /= entries[k];
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
