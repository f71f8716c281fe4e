#include "solver/energy_bound.h"

#include <algorithm>
#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

Real kinetic_energy(std::span<const std::uint32_t> island, const BodySet& bodies, Vec2 drift) {
  Real sum = 0;
  for (const std::uint32_t body : island) {
    const InverseMass& inverse = bodies.inverse_mass[body];
    const Velocity& velocity = bodies.velocity[body];
    const Vec2 v = velocity.v - drift;
    if (inverse.m > 0) sum += dot(v, v) / (2 * inverse.m);
    if (inverse.i > 0) sum += velocity.w * velocity.w / (2 * inverse.i);
  }
  return sum;
}

namespace {

Real mass_of(Real inverse) { return inverse > 0 ? 1 / inverse : Real{0}; }

/// The mean of a vector of each body, weighed by masses.
template <class Of>
Vec2 mean(std::span<const std::uint32_t> island, const BodySet& bodies, const Of& of) {
  Real mass = 0;
  Vec2 sum;
  for (std::size_t i = 0; i < island.size(); ++i) {
    const Real m = mass_of(bodies.inverse_mass[island[i]].m);
    mass += m;
    sum += m * of(i);
  }
  return mass > 0 ? sum / mass : Vec2{};
}

}  // namespace

/// Of the centre of mass; 0 if the island is held.
Vec2 EnergyBound::drift(const BodySet& bodies) const {
  if (held_) return {};
  return mean(island_, bodies, [&](std::size_t i) { return bodies.velocity[island_[i]].v; });
}

/// J, relative to the centre of mass.
Real EnergyBound::kinetic(const BodySet& bodies) const { return kinetic_energy(island_, bodies, drift(bodies)); }

void EnergyBound::note(std::span<const std::uint32_t> island, bool held, const BodySet& bodies,
                       const std::vector<Motion>& motion) {
  island_ = island;
  held_ = held;
  kinetic_ = kinetic(bodies);
  start_.clear();
  for (const std::uint32_t body : island) start_.push_back(motion[body]);
}

/// The energy at the start plus the work of the forces since.
Real EnergyBound::most(const BodySet& bodies, const std::vector<Motion>& motion,
                       const std::vector<Velocity>& acceleration) const {
  const auto moved = [&](std::size_t i) { return motion[island_[i]].d - start_[i].d; };
  const Vec2 drift = held_ ? Vec2{} : mean(island_, bodies, moved);
  Real most = kinetic_;
  for (std::size_t i = 0; i < island_.size(); ++i) {
    const std::uint32_t body = island_[i];
    const InverseMass& inverse = bodies.inverse_mass[body];
    most += mass_of(inverse.m) * dot(acceleration[body].v, moved(i) - drift) +
            mass_of(inverse.i) * acceleration[body].w * (motion[body].turn - start_[i].turn);
  }
  return most;
}

Real EnergyBound::excess(const BodySet& bodies, const std::vector<Motion>& motion,
                         const std::vector<Velocity>& acceleration, Real gain) const {
  return kinetic(bodies) - (most(bodies, motion, acceleration) + gain * kinetic_);
}

/// E = E_drift + E_turn + E_other: the three share no work, and the first needs no bound.
bool EnergyBound::keep(BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion,
                       const std::vector<Velocity>& acceleration, Real gain) const {
  const Real most = this->most(bodies, motion, acceleration);
  const Real now = kinetic(bodies);
  if (now <= most + gain * kinetic_) return false;
  const Vec2 drift = this->drift(bodies);
  const auto place = [&](std::size_t i) { return start[island_[i]].p + motion[island_[i]].d; };
  const Vec2 center = held_ ? Vec2{} : mean(island_, bodies, place);
  Real inertia = 0;
  Real spin = 0;
  for (std::size_t i = 0; i < island_.size() && !held_; ++i) {
    const InverseMass& inverse = bodies.inverse_mass[island_[i]];
    const Velocity& velocity = bodies.velocity[island_[i]];
    const Vec2 arm = place(i) - center;
    inertia += mass_of(inverse.m) * dot(arm, arm) + mass_of(inverse.i);
    spin += mass_of(inverse.m) * cross(arm, velocity.v - drift) + mass_of(inverse.i) * velocity.w;
  }
  const Real w = inertia > 0 ? spin / inertia : Real{0};
  const Real turns = w * spin / 2;  // J
  const auto share_of = [](Real room, Real energy) {
    return room > 0 && energy > 0 ? std::min(std::sqrt(room / energy), Real{1}) : Real{0};
  };
  const Real kept_turn = share_of(most, turns) * w;
  const Real share = share_of(most - turns, now - turns);
  for (std::size_t i = 0; i < island_.size(); ++i) {
    const InverseMass& inverse = bodies.inverse_mass[island_[i]];
    Velocity& velocity = bodies.velocity[island_[i]];
    const Vec2 around = perpendicular(place(i) - center);
    if (inverse.m > 0) velocity.v = drift + kept_turn * around + share * (velocity.v - drift - w * around);
    if (inverse.i > 0) velocity.w = kept_turn + share * (velocity.w - w);
  }
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
