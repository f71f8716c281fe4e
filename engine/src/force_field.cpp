#include "force_field.h"

namespace impulse::inline IMPULSE_PRECISION {

void ForceField::accelerations(const BodySet& bodies, Real implicit, std::vector<Velocity>& out) const {
  const std::size_t n = bodies.size();
  out.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const InverseMass inverse = bodies.inverse_mass[i];
    const Response& response = bodies.response[i];
    const Vec2 falling = inverse.m > 0 ? response.gravity_scale * gravity : Vec2{};
    out[i] = {falling + inverse.m * bodies.force[i], inverse.i * bodies.torque[i]};
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!(bodies.inverse_mass[i].m > 0)) continue;
    const Response& response = bodies.response[i];
    const Velocity& velocity = bodies.velocity[i];
    const Real linear = response.linear_damping;
    const Real angular = response.angular_damping;
    if (linear > 0) out[i].v = (out[i].v - linear * velocity.v) / (1 + implicit * linear);
    if (angular > 0) out[i].w = (out[i].w - angular * velocity.w) / (1 + implicit * angular);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
