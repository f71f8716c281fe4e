#pragma once

#include "bodies/body_set.h"
#include "bodies/force_field.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Carries free motion over h seconds in two halves; the solver corrects velocities in between.
class Integrator {
 public:
  Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  virtual ~Integrator() = default;

  /// Brings velocities to where contacts are solved.
  virtual void begin(BodySet& bodies, const ForceField& forces, Real h) = 0;
  /// Moves the poses with the solved velocities, and finishes the velocities where the method does so afterwards.
  virtual void finish(BodySet& bodies, const ForceField& forces, Real h) = 0;
  /// Free fall is off by drift * gravity * t * h.
  virtual Real drift() const = 0;
  /// Smooth free motion is off by a multiple of h^order.
  virtual int order() const = 0;
  /// So is sliding along what is touched, if contacts are solved exactly: what they give in a step moves the pose for
  /// the whole of it, as in symplectic Euler, whatever the order of the free motion.
  virtual int order_in_contact() const { return 1; }
  /// Whether it wants to know in the next step which bodies something held in this one (BodySet::held).
  virtual bool asks_what_is_held() const { return false; }
};

}  // namespace impulse::inline IMPULSE_PRECISION
