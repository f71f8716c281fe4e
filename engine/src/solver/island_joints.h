#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "core/softness.h"
#include "joints/joint_set.h"
#include "solver/joint_system.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m or rad, the error up to which joints count as satisfied.
constexpr Real tolerated_joint_gap = static_cast<Real>(1e-5);

/// Working storage for the joints of an island, reused from island to island.
struct JointWorkspace {
  JointSystem system;
  std::vector<Real> bias;
  std::vector<Real> before;  // impulses that can be restored
};

/// The softness of joints that are solved by iteration: 1/(6 h). At 1/(4 h) joints oscillate: a net of 20 x 20 that
/// falls and spins freely loses 16 kJ in 200 steps, at 1/(6 h) .6 and at 1/(8 h) .5 kJ in 300. At 1/(8 h) a net of 100
/// x 100 stretches by half as much again.
Softness softness_of_swept(Real h);

/// The joints of one island in the stages of `accurate`, by RATTLE (Andersen 1983): velocities before the drift are
/// chosen so that the joints are satisfied *after* it, with the rows before it; velocities after it so that they stay
/// satisfied, with the rows after it. Second order, and conserves energy.
///
/// If factoring all equations of the island would be expensive (a net of more than 18 x 18), joints are solved one
/// after another instead, like contacts: soft before the drift, rigid after it. First order; a joint then stretches by
/// its load / (2 m_eff w^2), with w of softness_of_swept.
class IslandJoints {
 public:
  IslandJoints(std::span<ActiveJoint* const> joints, std::span<const std::uint32_t> members, BodySet& bodies,
               const std::vector<Pose>& start, const std::vector<Motion>& motion, JointWorkspace& work);

  std::span<ActiveJoint* const> all() const { return joints_; }
  bool empty() const { return joints_.empty(); }
  /// Whether they are solved one after another.
  bool swept() const { return swept_; }
  /// Of factoring their equations, in additions and multiplications; not beyond where joints are swept.
  std::uint64_t cost() const { return cost_; }
  /// Scales impulses between a whole step and a sub-step.
  void share(Real by);
  /// Splits the impulses of the last sub-step in halves, which kick() applies again.
  void halve();
  void kick();
  /// Adds to these velocities of all bodies what kick() would change.
  void push_halves(std::vector<Velocity>& velocities) const;
  /// Solves error(x + h v) = 0.
  void press(Real h);
  /// Whether every press since the last drift satisfied them. That is not always possible: a chain pulled straight
  /// between two walls would need an infinite force.
  bool fit() const { return fit_; }
  /// Computes the rows at the current poses.
  void write();
  /// Clears the accumulated impulses: those of taut joints are no good warm start.
  void forget();
  /// Solves rate = 0.
  void relax(Real h);
  /// Makes the velocities after an impact satisfy the joints, without accumulating impulses.
  void absorb_impact();

 private:
  JointPose pose(std::uint32_t body, Real ahead) const;
  JointBlock ahead(const ActiveJoint& joint, Real h) const;
  Real miss(Real h);
  Real good_enough() const;
  bool fit_by_present_rows(Real h);
  void write_rows(Real ahead, Real give_way);
  void approach_by_rows_ahead(Real h, Real most);
  Real most_energy() const;
  void press_by_sweep(Real h);
  void relax_by_sweep(Real h);
  void drive(JointBlock& block, JointRow& row, Real wanted, Real least, Real most);
  void drive_motors(Real h);
  void remember();
  void take_back();

  std::span<ActiveJoint* const> joints_;
  std::span<const std::uint32_t> members_;
  BodySet& bodies_;
  const std::vector<Pose>& start_;
  const std::vector<Motion>& motion_;
  JointWorkspace& work_;
  std::uint64_t cost_;
  bool swept_;
  bool fit_ = true;
};

}  // namespace impulse::inline IMPULSE_PRECISION
