#include "solver/joint_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// A pivot below this fraction of its diagonal is the rounding error of an equation that others already imply (a closed
/// loop): it gets no impulse.
constexpr Real redundant = 64 * std::numeric_limits<Real>::epsilon();

bool is_angle(const JointRow& row) { return row.axis == Vec2{}; }

/// The change of the rate of p for a unit impulse along q, through the bodies that both act on.
Real coupling(const JointBlock& of_p, const JointRow& p, const JointBlock& of_q, const JointRow& q) {
  const auto through = [&](const InverseMass& mass, Real arm_p, Real arm_q) {
    return mass.m * dot(p.axis, q.axis) + mass.i * arm_p * arm_q;
  };
  Real sum = 0;
  if (of_p.a == of_q.a) sum += through(of_p.inv_mass_a, p.arm_a, q.arm_a);
  if (of_p.b == of_q.b) sum += through(of_p.inv_mass_b, p.arm_b, q.arm_b);
  if (of_p.a == of_q.b) sum -= through(of_p.inv_mass_a, p.arm_a, q.arm_b);
  if (of_p.b == of_q.a) sum -= through(of_p.inv_mass_b, p.arm_b, q.arm_a);
  return sum;
}

/// 1/kg or 1/(kg m^2), the inverse effective mass that the compliance of an equation is measured by: its own, but of
/// the two along the axes of the world their mean, so that a joint gives way alike however the scene is turned.
Real own_inverse_mass(const JointBlock& block, const JointRow& row) {
  Real sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
    const JointRow& other = block.equation[i];
    if (is_angle(other) != is_angle(row)) continue;
    sum += coupling(block, other, block, other);
    ++count;
  }
  return sum / static_cast<Real>(count);
}

}  // namespace

std::uint64_t factoring_cost(std::span<const std::size_t> first, std::uint64_t most) {
  std::uint64_t cost = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = first[i]; j <= i; ++j) {
      cost += 1 + j - std::max(first[i], first[j]);
      if (cost > most) return cost;
    }
  }
  return cost;
}

std::uint64_t JointSystem::cost(std::span<ActiveJoint* const> joints, std::size_t bodies, std::uint64_t most) {
  lay_out(joints, bodies);
  return factoring_cost(first_, most);
}

void JointSystem::lay_out(std::span<ActiveJoint* const> joints, std::size_t bodies) {
  lowest_.resize(bodies, none);
  first_.clear();
  for (const ActiveJoint* joint : joints) {
    const JointBlock& block = joint->block;
    const std::size_t here = first_.size();
    std::size_t first = here;
    const std::array<std::pair<std::uint32_t, InverseMass>, 2> ends{
        {{block.a, block.inv_mass_a}, {block.b, block.inv_mass_b}}};
    for (const auto& [body, mass] : ends) {
      if (!pushable(mass)) continue;
      if (lowest_[body] == none) lowest_[body] = here;
      first = std::min(first, lowest_[body]);
    }
    first_.insert(first_.end(), static_cast<std::size_t>(block.equations), first);
  }
  for (const ActiveJoint* joint : joints) lowest_[joint->block.a] = lowest_[joint->block.b] = none;
}

void JointSystem::factor(std::span<ActiveJoint* const> joints, std::size_t bodies, Real give) {
  lay_out(joints, bodies);
  values_.clear();
  start_.clear();
  give_.clear();
  // Each equation with its joint.
  std::vector<std::pair<const JointBlock*, const JointRow*>> rows;
  for (const ActiveJoint* joint : joints) {
    const JointBlock& block = joint->block;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
      rows.emplace_back(&block, &block.equation[i]);
      start_.push_back(values_.size());
      for (std::size_t j = first_[rows.size() - 1]; j < rows.size(); ++j) {
        values_.push_back(coupling(block, block.equation[i], *rows[j].first, *rows[j].second));
      }
      give_.push_back(give * own_inverse_mass(block, block.equation[i]));
      values_.back() += give_.back();
    }
  }
  solution_.resize(rows.size());

  // Row by row: g = L D of the row, then L and the pivot D.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Real diagonal = entry(i, i);
    for (std::size_t j = first_[i]; j < i; ++j) {
      Real g = entry(i, j);
      for (std::size_t k = std::max(first_[i], first_[j]); k < j; ++k) g -= entry(i, k) * entry(j, k);
      entry(i, j) = g;
    }
    Real pivot = diagonal;
    for (std::size_t j = first_[i]; j < i; ++j) {
      const Real g = entry(i, j);
      const Real l = entry(j, j) > 0 ? g / entry(j, j) : Real{0};
      pivot -= g * l;
      entry(i, j) = l;
    }
    entry(i, i) = pivot > redundant * diagonal ? pivot : Real{0};
  }
}

void JointSystem::solve(std::span<ActiveJoint* const> joints, const BodySet& bodies, std::span<const Real> bias) {
  std::size_t next = 0;
  for (const ActiveJoint* joint : joints) {
    const JointBlock& block = joint->block;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i, ++next) {
      solution_[next] = -(rate(block.equation[i], bodies.velocity[block.a], bodies.velocity[block.b]) + bias[next]);
    }
  }
  std::vector<Real>& x = solution_;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = first_[i]; j < i; ++j) x[i] -= entry(i, j) * x[j];
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = entry(i, i) > 0 ? x[i] / entry(i, i) : Real{0};
  for (std::size_t i = x.size(); i-- > 0;) {
    for (std::size_t j = first_[i]; j < i; ++j) x[j] -= entry(i, j) * x[i];
  }
}

Real JointSystem::largest() const {
  Real most = 0;
  for (const Real impulse : solution_) most = std::max(most, std::abs(impulse));
  return most;
}

void JointSystem::push(std::span<ActiveJoint* const> joints, BodySet& bodies, Real share, bool accumulate) const {
  std::size_t next = 0;
  for (ActiveJoint* joint : joints) {
    JointBlock& block = joint->block;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i, ++next) {
      const Real impulse = share * solution_[next];
      apply(block, block.equation[i], impulse, bodies.velocity[block.a], bodies.velocity[block.b]);
      if (accumulate) block.equation[i].impulse += impulse;
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
