#include "solver/unpushed.h"

namespace impulse::inline IMPULSE_PRECISION {

void Unpushed::note(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration) {
  flown_.clear();
  for (const std::uint32_t body : island.bodies) {
    Velocity v = bodies.velocity[body];
    for (int half = 0; half < 2; ++half) {
      v.v += island.h / 2 * acceleration[body].v;
      v.w += island.h / 2 * acceleration[body].w;
    }
    flown_.push_back(v);
  }
}

void Unpushed::restore(const Island& island, const std::vector<std::uint8_t>& loaded, BodySet& bodies) const {
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const std::uint32_t body = island.bodies[i];
    const InverseMass& mass = bodies.inverse_mass[body];
    if (loaded[body] == 0 && mass.m + mass.i > 0) bodies.velocity[body] = flown_[i];
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
