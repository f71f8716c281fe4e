#pragma once

#include <vector>

#include "contacts/contact_rows.h"
#include "joints/joint_set.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The poses of all bodies at the start of the step.
struct StartPoses {
  const std::vector<Pose>& pose;
  const std::vector<Real>& angle;
};

/// Moves two bodies to satisfy a joint and its stops completely, by up to .2 m.
void close_joint(const ActiveJoint& joint, const StartPoses& start, Motion& a, Motion& b);

/// Removes overlap and joint errors by moving bodies, without changing their velocities: nonlinear Gauss-Seidel, with
/// every separation computed from the current poses. Each iteration removes a fifth of the overlap beyond the slop, and
/// joint errors completely.
class PositionCorrection {
 public:
  /// To be called after the bodies have moved from `start`, where the rows were made.
  template <class Row>
  void run(BodySet& bodies, const std::vector<Row>& rows, const std::vector<ActiveJoint>& joints,
           const StartPoses& start, Real slop, int iterations) {
    begin(bodies, start);
    for (int i = 0; i < iterations; ++i) {
      for (const ActiveJoint& joint : joints) {
        close_joint(joint, start, motion_[joint.block.a], motion_[joint.block.b]);
      }
      for (const Row& row : rows) part(row, slop);
    }
    finish(bodies);
  }

 private:
  void begin(const BodySet& bodies, const StartPoses& start);
  void part(const ContactRow& row, Real slop);
  void finish(BodySet& bodies) const;

  std::vector<Motion> motion_;  // of each body since the start of the step
  std::vector<Motion> moved_;   // motion_ before the correction
};

}  // namespace impulse::inline IMPULSE_PRECISION
