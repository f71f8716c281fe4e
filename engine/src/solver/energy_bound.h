#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The kinetic energy (J) of the bodies that can be pushed, as seen by who moves at `drift`, m/s.
Real kinetic_energy(std::span<const std::uint32_t> island, const BodySet& bodies, Vec2 drift = {});

/// Ideal joints and contacts do no positive work. If joints could not be satisfied, an island's kinetic energy after a
/// sub-step is limited to its previous energy plus the work of its forces, by slowing all its bodies by the same
/// factor. An island that nothing holds is measured from its centre of mass, which goes on as it does, and what it
/// turns as a whole, its angular momentum, is slowed last. A motor's work in such a sub-step is lost.
class EnergyBound {
 public:
  /// Records the state at the start of a sub-step. `held`: a body that cannot be pushed holds the island.
  void note(std::span<const std::uint32_t> island, bool held, const BodySet& bodies, const std::vector<Motion>& motion);

  /// J, the growth of the kinetic energy beyond the work of the forces and the fraction `gain` of the energy at the
  /// start; negative if it grew less. `acceleration` is the force field's, m/s^2 and rad/s^2.
  Real excess(const BodySet& bodies, const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration,
              Real gain) const;

  /// Slows the bodies if necessary, and returns whether it was. They are where `motion` brings them from `start`.
  bool keep(BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion,
            const std::vector<Velocity>& acceleration, Real gain) const;

 private:
  Vec2 drift(const BodySet& bodies) const;
  Real kinetic(const BodySet& bodies) const;
  Real most(const BodySet& bodies, const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration) const;

  std::span<const std::uint32_t> island_;
  bool held_ = false;
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
