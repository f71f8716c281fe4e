#pragma once

#include <algorithm>

#include "impulse/math.h"
#include "core/softness.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How the standing offset o of a contact follows the depth x that its load presses in, from step to step:
///
///   o += gain x - leak o
class OffsetRule {
 public:
  /// steps; the first ones of a contact are no standing load yet.
  static constexpr int from_age = 2;

  OffsetRule() = default;

  /// Lifts what has sunk altogether, with o' = r x: r is 2/s, or less where that would pump the pile's slowest wave. L
  /// layers on springs of frequency w and damping ratio z swing with W = w pi / (2 L), damped by c = 2 z w (pi / (2
  /// L))^2; with the offset o as part of the spring, x'' + c x' + W^2 (x + o) = g and o' = r x, which is stable for r <
  /// c. A pyramid of 100 rows, c = .6/s, shakes without end at r = 1/s and for 20 s at .5; r = c / 4 costs it a quarter
  /// of its damping.
  static OffsetRule lifting(Real dt, Real layers, Real damping_ratio, const Softness& soft) {
    const Real wave = pi / (2 * layers);
    const Real damping = 2 * damping_ratio * soft.omega * wave * wave;
    constexpr Real soonest = 2;  // 1/s; 1 ... 4 are all stable in stacks of ten, 2 settles soonest
    OffsetRule rule;
    rule.gain_ = dt * std::min(soonest, damping / 4);
    return rule;
  }

  /// Lifts up to two thirds of what has sunk, and never gives energy to anything. For heaps: what rolls and slides
  /// there has slow modes that no spring damps, and to these an offset that lifts without an end is a motor. A spring k
  /// with the damper k q, q = 2 z / w, and o' = r x - l o answers a depth that swings with W by the stiffness
  ///
  ///   k (1 + r / (i W + l)) + i W k q
  ///
  /// and takes energy where its imaginary part is positive: q > r / (W^2 + l^2). Without the leak l this fails below
  /// W = sqrt(r / q), whatever r: 2000 smooth discs in a box moved at .04 m/s for as long as one looked, 1000 discs and
  /// 1000 boxes with friction at .01 m/s after 15 s (and at .0001 with this rule). With r / l^2 < q it never fails. In
  /// steps of dt, o += gain x - leak o is as late as its depths are old on the mean, (1 - leak) / leak steps, and half
  /// a step because it then stays for one: (gain / leak) ((1 - leak) / leak + 1 / 2) dt < q. Three quarters of that are
  /// taken at most; and gain + leak <= 1, lest the offset overshoot.
  static OffsetRule passive(Real dt, Real damping_ratio) {
    OffsetRule rule;
    rule.leak_ = Real{1} / 3;
    constexpr Real taken = Real{3} / 4;
    const Real late = dt * ((1 - rule.leak_) / rule.leak_ + Real{1} / 2);
    rule.gain_by_omega_ = rule.leak_ * taken * 2 * damping_ratio / late;
    return rule;
  }

  /// Of a contact so soft.
  Real gain(const Softness& soft) const {
    if (leak_ == 0) return gain_;
    return std::min(gain_by_omega_ / soft.omega, 1 - leak_);
  }
  Real leak() const { return leak_; }

 private:
  Real gain_ = 0;  // where nothing leaks
  Real leak_ = 0;
  Real gain_by_omega_ = 0;  // rad/s
};

}  // namespace impulse::inline IMPULSE_PRECISION
