#pragma once

#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "joints/joint_set.h"
#include "solver/joint_system.h"
#include "solver/motion.h"
#include "core/softness.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What the joints of an island work with; kept from island to island for its storage.
struct JointWorkspace {
  JointSystem system;
  std::vector<Real> bias;
  std::vector<Real> before;  // impulses that can be gone back to
};

/// Of the springs that swept joints are: 1/(6 h). At 1/(4 h) joints shake: a net of 20 x 20 that falls and spins freely
/// loses 16 kJ in 200 steps, at 1/(6 h) .6 and at 1/(8 h) .5 kJ in 300. At 1/(8 h) a net of 100 x 100 stretches by half
/// as much again.
Softness softness_of_swept(Real h);

/// The joints of one island through the stages of `accurate`, as RATTLE (Andersen 1983) does it: velocities before the
/// drift are chosen so that the joints fit *after* it, with the rows of before; velocities after it so that they go on
/// fitting, with the rows of after. Second order, and it keeps the energy.
///
/// Where factoring all equations of the island would be dear (a net of more than 18 x 18), joints are swept one
/// after another instead, as contacts are: damped springs before the drift, rigid after it. First order; a joint then
/// stretches by its load / (2 m_eff w^2), with w of softness_of_swept.
class IslandJoints {
 public:
  IslandJoints(std::span<ActiveJoint* const> joints, std::span<const std::uint32_t> members, BodySet& bodies,
               const std::vector<Pose>& start, const std::vector<Motion>& motion, JointWorkspace& work);

  std::span<ActiveJoint* const> all() const { return joints_; }
  bool empty() const { return joints_.empty(); }
  /// Whether they are swept one after another.
  bool swept() const { return swept_; }
  /// Impulses of a whole step to those of one of n sub-steps, and back.
  void share(Real by);
  /// What the joints gave in the last sub-step is given again, half in each kick.
  void halve();
  void kick();
  /// error(x + h v) = 0.
  void press(Real h);
  /// Whether every press since the last drift made them fit. They cannot always: a chain pulled straight between two
  /// walls would need an infinite force.
  bool fit() const { return fit_; }
  /// Rows as the bodies stand.
  void write();
  /// What taut joints gave is no guess at what they will give next.
  void forget();
  /// rate = 0.
  void relax(Real h);
  /// Velocities that fit the joints, from an impact's; nothing is accumulated.
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
  void remember();
  void take_back();

  std::span<ActiveJoint* const> joints_;
  std::span<const std::uint32_t> members_;
  BodySet& bodies_;
  const std::vector<Pose>& start_;
  const std::vector<Motion>& motion_;
  JointWorkspace& work_;
  bool swept_;
  bool fit_ = true;
};

}  // namespace impulse::inline IMPULSE_PRECISION
