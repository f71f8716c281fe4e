#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Multiplications that it takes to factor a matrix in skyline storage: entry (i, j) takes those that the rows i and j
/// share before column j, and one. `first` has the column of each row's first entry. Counts no further than beyond
/// `most`.
std::uint64_t factoring_cost(std::span<const std::size_t> first, std::uint64_t most);

/// All joint equations of an island as one linear system, K d = -(rate + bias), K the inverse effective masses between
/// every two equations. Solved directly, so that a chain with a heavy end needs no sweeps: K = L D L^T in skyline
/// storage (each row from its first entry on), whose cost for a chain of n joints is proportional to n.
class JointSystem {
 public:
  /// What factoring will take, as factoring_cost says.
  std::uint64_t cost(std::span<ActiveJoint* const> joints, std::size_t bodies, std::uint64_t most);

  /// Of the rows as they stand. Each equation gives way by a share `give` of its own inverse effective mass, as if its
  /// joint were a spring: what many joints cannot all have exactly then stays finite.
  void factor(std::span<ActiveJoint* const> joints, std::size_t bodies, Real give);

  /// Finds the impulses that bring the rates to -bias. `bias` has one entry an equation, in the joints' order.
  void solve(std::span<ActiveJoint* const> joints, const BodySet& bodies, std::span<const Real> bias);

  /// Gives a share of the impulses found last. Where `accumulate`, the joints remember them.
  void push(std::span<ActiveJoint* const> joints, BodySet& bodies, Real share, bool accumulate) const;

  /// By which an equation's rate lags behind for each unit of its impulse, in 1/kg or 1/(kg m^2).
  Real give(std::size_t equation) const { return give_[equation]; }

  std::size_t equations() const { return first_.size(); }

 private:
  void lay_out(std::span<ActiveJoint* const> joints, std::size_t bodies);
  Real& entry(std::size_t row, std::size_t column) { return values_[start_[row] + column - first_[row]]; }
  Real entry(std::size_t row, std::size_t column) const { return values_[start_[row] + column - first_[row]]; }

  std::vector<Real> values_;         // rows from first_ up to the diagonal
  std::vector<std::size_t> start_;   // of each row in values_
  std::vector<std::size_t> first_;   // column of each row's first entry
  std::vector<std::size_t> lowest_;  // of each body, the first equation that moves it; none between calls
  std::vector<Real> give_;           // of each row
  std::vector<Real> solution_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
