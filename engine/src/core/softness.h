#pragma once

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A soft constraint, which yields like a damped spring (E. Catto, "Soft Constraints", GDC 2011):
///
///   impulse = -m [ mass_scale (v + bias_rate s) ] - impulse_scale * lambda
///
/// with m the effective mass, v the relative velocity, s the position error, lambda the accumulated impulse.
/// mass_scale + impulse_scale = 1. By default it is rigid.
struct Softness {
  Real bias_rate = 0;      // 1/s
  Real mass_scale = 1;     // share of the rigid impulse
  Real impulse_scale = 0;  // share of the accumulated impulse that is taken back
  Real omega = 0;          // rad/s

  /// A spring with this frequency (Hz), integrated implicitly with steps of h (s).
  static Softness of(Real frequency, Real damping_ratio, Real h) {
    const Real omega = 2 * pi * frequency;
    const Real damping = 2 * damping_ratio + h * omega;
    const Real stiffness = h * omega * damping;
    return {omega / damping, stiffness / (1 + stiffness), 1 / (1 + stiffness), omega};
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
