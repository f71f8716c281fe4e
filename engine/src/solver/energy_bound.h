#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// J, of the bodies that can be pushed.
Real kinetic_energy(std::span<const std::uint32_t> island, const BodySet& bodies);

/// Ideal joints and contacts do no work, or take it. Where joints could not be made to fit, an island's kinetic energy
/// after a sub-step is held to what it had and what its forces gave, by slowing all its bodies alike: where nothing
/// holds the island, as seen from what they would be moving as one rigid body, so that momentum stays. A motor's work
/// in such a sub-step is lost.
class EnergyBound {
 public:
  /// Remembers how the bodies are at the start of a sub-step.
  void note(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion);

  /// J, by which the kinetic energy has grown more than by what the forces gave and that share of what it was; less
  /// than 0 where it has not.
  Real excess(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion,
              const std::vector<Velocity>& acceleration, Real gain) const;

  /// Whether anything had to be slowed. `held`: something that cannot be pushed holds the island. `acceleration` is the
  /// force field's, m/s^2 and rad/s^2.
  bool keep(std::span<const std::uint32_t> island, bool held, BodySet& bodies, const std::vector<Motion>& motion,
            const std::vector<Velocity>& acceleration, Real gain) const;

 private:
  Real most(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion,
            const std::vector<Velocity>& acceleration) const;

  Real kinetic_ = 0;           // J
  std::vector<Motion> start_;  // of the island's bodies
};

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
