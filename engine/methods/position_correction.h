#pragma once

#include <vector>

#include "contacts/contact_rows.h"
#include "joints/joint_set.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where all bodies were at the start of the step.
struct StartPoses {
  const std::vector<Pose>& pose;
  const std::vector<Real>& angle;
};

/// Moves two bodies so that a joint fits (stops too), whatever it takes, up to .2 m.
void close_joint(const ActiveJoint& joint, const StartPoses& start, Motion& a, Motion& b);

/// Removes overlap and the errors of joints by moving bodies, with no trace in their velocities: nonlinear
/// Gauss-Seidel, every separation taken anew where the bodies stand just then. Of the overlap beyond the slop a fifth
/// goes in each iteration; joints are closed at once.
class PositionCorrection {
 public:
  /// After the bodies have moved from `start` (rows are of there).
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
  std::vector<Motion> moved_;   // the same before the correction
};

}  // namespace impulse::inline IMPULSE_PRECISION
