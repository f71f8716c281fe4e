#pragma once

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A contact that gives way like a damped spring, in the terms of Catto's soft constraints (GDC 2011):
///
///   impulse = -m [ strength (v + rate s) ] - relief * lambda
///
/// with m the effective mass, s the depth, lambda what has been given already. strength + relief = 1.
struct Softness {
  Real rate = 0;      // 1/s
  Real strength = 1;  // share of the rigid impulse
  Real relief = 0;    // share of the accumulated impulse that is given back
  Real omega = 0;     // rad/s

  /// The same that bears a blow at once.
  Softness rigid() const { return {rate, 1, 0, omega}; }

  /// A spring of that frequency (Hz), integrated implicitly with steps of h.
  static Softness of(Real frequency, Real damping_ratio, Real h) {
    const Real omega = 2 * pi * frequency;
    const Real damping = 2 * damping_ratio + h * omega;
    const Real stiffness = h * omega * damping;
    return {omega / damping, stiffness / (1 + stiffness), 1 / (1 + stiffness), omega};
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
