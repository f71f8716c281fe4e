#pragma once

#include <vector>

#include "body_set.h"
#include "joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Continuous collision: a body that a step carried through something is put back to where it met it, and the next step
/// finds the contact. What is left of its step is lost. Solvers that look ahead know the points that will touch first;
/// what a corner's impact turns into the wall they need this for, too.
class Sweep {
 public:
  /// Before the step.
  void remember(const BodySet& bodies);
  /// After it. Looks only at bodies that moved farther than half their thickness: slower ones cannot have passed
  /// through. They meet fixed and kinematic bodies, and a `bullet` meets all, as these stand at the end of the step.
  void hold_back(BodySet& bodies, const JointSet& joints) const;

 private:
  struct Path;
  struct Stop {
    Real after = 1;         // share of the step
    bool turns_on = false;  // only the way is cut short
  };
  Path path(const BodySet& bodies, std::size_t i) const;
  Stop first_stop(const BodySet& bodies, const JointSet& joints, std::size_t i) const;
  static Stop stop_at(const Shape& standing, const Pose& pose, const Shape& moving, Real thickness, const Path& path,
                      Real reach);

  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
