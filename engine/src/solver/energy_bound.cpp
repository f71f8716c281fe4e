#include "solver/energy_bound.h"

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

namespace {

/// The motion as one rigid body with the same momentum and angular momentum.
class RigidMotion {
 public:
  RigidMotion() = default;
  RigidMotion(std::span<const std::uint32_t> island, const BodySet& bodies) {
    Real mass = 0;
    Vec2 momentum;
    for (const std::uint32_t body : island) {
      const Real m = mass_of(bodies.inverse_mass[body].m);
      mass += m;
      center_ += m * bodies.pose[body].p;
      momentum += m * bodies.velocity[body].v;
    }
    if (mass == 0) return;
    center_ = center_ / mass;
    velocity_.v = momentum / mass;
    Real inertia = 0;
    Real spin = 0;
    for (const std::uint32_t body : island) {
      const Real m = mass_of(bodies.inverse_mass[body].m);
      const Real i = mass_of(bodies.inverse_mass[body].i);
      const Vec2 arm = bodies.pose[body].p - center_;
      inertia += m * dot(arm, arm) + i;
      spin += m * cross(arm, bodies.velocity[body].v - velocity_.v) + i * bodies.velocity[body].w;
    }
    velocity_.w = inertia > 0 ? spin / inertia : 0;
    energy_ = mass * dot(velocity_.v, velocity_.v) / 2 + inertia * velocity_.w * velocity_.w / 2;
  }

  Real energy() const { return energy_; }  // J
  Velocity at(std::uint32_t body, const BodySet& bodies) const {
    return {velocity_.v + velocity_.w * perpendicular(bodies.pose[body].p - center_), velocity_.w};
  }

 private:
  static Real mass_of(Real inverse) { return inverse > 0 ? 1 / inverse : Real{0}; }

  Vec2 center_;
  Velocity velocity_;
  Real energy_ = 0;
};

}  // namespace

void EnergyBound::note(std::span<const std::uint32_t> island, const BodySet& bodies,
                       const std::vector<Motion>& motion) {
  kinetic_ = kinetic_energy(island, bodies);
  start_.clear();
  for (const std::uint32_t body : island) start_.push_back(motion[body]);
}

/// The energy at the start plus the work of the forces since.
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

Real EnergyBound::excess(std::span<const std::uint32_t> island, const BodySet& bodies,
                         const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration,
                         Real gain) const {
  return kinetic_energy(island, bodies) - (most(island, bodies, motion, acceleration) + gain * kinetic_);
}

bool EnergyBound::keep(std::span<const std::uint32_t> island, bool held, BodySet& bodies,
                       const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real gain) const {
  const Real most = this->most(island, bodies, motion, acceleration);
  const Real now = kinetic_energy(island, bodies);
  if (now <= most + gain * kinetic_) return false;
  // E = E_rigid + E_other: the two share no work.
  const RigidMotion rigid = held ? RigidMotion() : RigidMotion(island, bodies);
  const Real room = most - rigid.energy();
  const Real share = room > 0 ? std::sqrt(room / (now - rigid.energy())) : Real{0};
  for (const std::uint32_t body : island) {
    const InverseMass& inverse = bodies.inverse_mass[body];
    Velocity& velocity = bodies.velocity[body];
    const Velocity kept = rigid.at(body, bodies);
    if (inverse.m > 0) velocity.v = kept.v + share * (velocity.v - kept.v);
    if (inverse.i > 0) velocity.w = kept.w + share * (velocity.w - kept.w);
  }
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
