#include "solvers/energy_bound.h"

#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

Real kinetic_energy(std::span<const std::uint32_t> island, const BodySet& bodies) {
  Real sum = 0;
  for (const std::uint32_t body : island) {
    const InverseMass& inverse = bodies.inverse_mass[body];
    const Velocity& velocity = bodies.velocity[body];
    if (inverse.m > 0) sum += dot(velocity.v, velocity.v) / (2 * inverse.m);
    if (inverse.i > 0) sum += velocity.w * velocity.w / (2 * inverse.i);
  }
  return sum;
}

void EnergyBound::note(std::span<const std::uint32_t> island, const BodySet& bodies,
                       const std::vector<Motion>& motion) {
  kinetic_ = kinetic_energy(island, bodies);
  start_.clear();
  for (const std::uint32_t body : island) start_.push_back(motion[body]);
}

/// What the island had and what its forces gave since.
Real EnergyBound::most(std::span<const std::uint32_t> island, const BodySet& bodies, const std::vector<Motion>& motion,
                       const std::vector<Velocity>& acceleration) const {
  Real most = kinetic_;
  for (std::size_t i = 0; i < island.size(); ++i) {
    const std::uint32_t body = island[i];
    const InverseMass& inverse = bodies.inverse_mass[body];
    if (inverse.m > 0) most += dot(acceleration[body].v, motion[body].d - start_[i].d) / inverse.m;
    if (inverse.i > 0) most += acceleration[body].w * (motion[body].turn - start_[i].turn) / inverse.i;
  }
  return most;
}

bool EnergyBound::exceeded(std::span<const std::uint32_t> island, const BodySet& bodies,
                           const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration,
                           Real gain) const {
  return kinetic_energy(island, bodies) > most(island, bodies, motion, acceleration) + gain * kinetic_;
}

bool EnergyBound::keep(std::span<const std::uint32_t> island, BodySet& bodies, const std::vector<Motion>& motion,
                       const std::vector<Velocity>& acceleration, Real gain) const {
  const Real most = this->most(island, bodies, motion, acceleration);
  const Real now = kinetic_energy(island, bodies);
  if (now <= most + gain * kinetic_) return false;
  const Real share = most > 0 ? std::sqrt(most / now) : Real{0};
  for (const std::uint32_t body : island) {
    if (bodies.inverse_mass[body].m + bodies.inverse_mass[body].i == 0) continue;
    bodies.velocity[body].v *= share;
    bodies.velocity[body].w *= share;
  }
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
