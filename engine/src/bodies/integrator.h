#pragma once

#include "bodies/body_set.h"
#include "bodies/force_field.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Integrates free motion over h seconds in two parts; the solver corrects the velocities in between.
class Integrator {
 public:
  Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  virtual ~Integrator() = default;

  /// Updates the velocities to those at which contacts are solved.
  virtual void begin(BodySet& bodies, const ForceField& forces, Real h) = 0;
  /// Moves the poses with the solved velocities, and completes the velocity update if the method does so afterwards.
  virtual void finish(BodySet& bodies, const ForceField& forces, Real h) = 0;
  /// Free fall is off by drift * gravity * t * h.
  virtual Real drift() const = 0;
  /// The error of smooth free motion is proportional to h^order.
  virtual int order() const = 0;
  /// The same for sliding along a contact that is solved exactly. It is 1 for most methods, whatever their order in
  /// free motion: contact impulses act on the pose for the whole step, as in symplectic Euler.
  virtual int order_in_contact() const { return 1; }
  /// Whether it reads BodySet::held, which records the bodies that contacts or joints acted on in the last step.
  virtual bool needs_held() const { return false; }
};

}  // namespace impulse::inline IMPULSE_PRECISION
