#pragma once

#include <limits>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Relaxation until an island has no more energy than it may have. The impulses of press and relax together are those
/// of an impact without rebound, which takes energy, once relax has converged: until then some of the speed that only
/// parts the bodies is left in them. But not all that is too much goes with the sweeps: bodies that turn within a
/// sub-step gain some too. As each sweep takes less than the one before, there is no hope where as many as are left
/// would not do at the rate of the last.
class Descent {
 public:
  explicit Descent(int sweeps) : left_(sweeps) {}

  /// Whether to relax once more. `excess`: J, above what the island may have.
  bool goes_on(Real excess) {
    const bool hopeful = excess > 0 && (last_ - excess) * static_cast<Real>(left_) >= excess;
    last_ = excess;
    return hopeful && left_-- > 0;
  }

 private:
  int left_;
  Real last_ = std::numeric_limits<Real>::infinity();
};

}  // namespace impulse::inline IMPULSE_PRECISION
