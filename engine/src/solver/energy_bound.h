#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The kinetic energy (J) of the bodies that can be pushed.
Real kinetic_energy(std::span<const std::uint32_t> island, const BodySet& bodies);

/// Ideal joints and contacts do no positive work. If joints could not be satisfied, an island's kinetic energy after a
/// sub-step is limited to its previous energy plus the work of its forces, by slowing all its bodies by the same
/// factor: for a free island relative to its motion as one rigid body, so that momentum is conserved. A motor's work in
/// such a sub-step is lost.
class EnergyBound {
 public:
  /// Records the state at the start of a sub-step.
  void note(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion);

  /// J, the growth of the kinetic energy beyond the work of the forces and the fraction `gain` of the energy at the
  /// start; negative if it grew less.
  Real excess(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion,
              const std::vector<Velocity>& acceleration, Real gain) const;

  /// Slows the bodies if necessary, and returns whether it was. `held`: a body that cannot be pushed holds the island.
  /// `acceleration` is the force field's, m/s^2 and rad/s^2.
  bool keep(std::span<const std::uint32_t> island, bool held, BodySet& bodies, const std::vector<Motion>& motion,
            const std::vector<Velocity>& acceleration, Real gain) const;

 private:
  Real most(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion,
            const std::vector<Velocity>& acceleration) const;

  Real kinetic_ = 0;           // J
  std::vector<Motion> start_;  // of the island's bodies
};

/// The energy-based stop of relaxation: iterates until an island has no more energy than allowed. Once relax has
/// converged, the impulses of press and relax together are those of an impact without rebound, which removes energy;
/// until then some of the separating speed is left. But iterations do not remove all excess: bodies that rotate within
/// a sub-step gain energy too. Each iteration removes less than the one before, so it is hopeless if the remaining ones
/// would not suffice at the rate of the last.
class Descent {
 public:
  explicit Descent(int sweeps) : left_(sweeps) {}

  /// Whether to relax once more; `excess` is the energy (J) above the allowed one.
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
