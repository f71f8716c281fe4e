#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The number of multiplications to factor a matrix in skyline storage: entry (i, j) takes one and as many as the rows
/// i and j overlap before column j. `first` has the column of each row's first entry. Stops counting above `most`.
std::uint64_t factoring_cost(std::span<const std::size_t> first, std::uint64_t most);

/// All joint equations of an island as one linear system, K d = -(rate + bias), K the inverse effective masses between
/// every two equations. Solved directly, so that a chain with a heavy end needs no iterations: K = L D L^T in skyline
/// storage (each row from its first entry on), whose cost for a chain of n joints is proportional to n.
class JointSystem {
 public:
  /// The cost of factor(), see factoring_cost().
  std::uint64_t cost(std::span<ActiveJoint* const> joints, std::size_t bodies, std::uint64_t most);

  /// Factors K of the current rows. Each equation has a compliance, the fraction `give` of its own inverse effective
  /// mass, as if its joint were a spring: impulses stay finite if not all joints can be satisfied exactly.
  void factor(std::span<ActiveJoint* const> joints, std::size_t bodies, Real give);

  /// Finds the impulses that bring the rates to -bias. `bias` has one entry an equation, in the joints' order.
  void solve(std::span<ActiveJoint* const> joints, const BodySet& bodies, std::span<const Real> bias);

  /// N s or N m s, the largest of the impulses found last.
  Real largest() const;

  /// Applies a fraction of the impulses found last, and adds it to the joints' accumulated impulses if `accumulate`.
  void push(std::span<ActiveJoint* const> joints, BodySet& bodies, Real share, bool accumulate) const;

  /// The compliance of an equation, 1/kg or 1/(kg m^2).
  Real give(std::size_t equation) const { return give_[equation]; }

  std::size_t equations() const { return first_.size(); }

 private:
  void lay_out(std::span<ActiveJoint* const> joints, std::size_t bodies);
  Real& entry(std::size_t row, std::size_t column) { return values_[start_[row] + column - first_[row]]; }
  Real entry(std::size_t row, std::size_t column) const { return values_[start_[row] + column - first_[row]]; }

  std::vector<Real> values_;         // rows from first_ up to the diagonal
  std::vector<std::size_t> start_;   // of each row in values_
  std::vector<std::size_t> first_;   // column of each row's first entry
  std::vector<std::size_t> lowest_;  // of each body, the first equation that moves it; reset to none after each use
  std::vector<Real> give_;           // of each row
  std::vector<Real> solution_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
