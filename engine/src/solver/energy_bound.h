#pragma once

#include <cstdint>
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

}  // namespace impulse::inline IMPULSE_PRECISION
