#include "core/simd.h"
#include "solver/lanes/contact_lanes.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

/// Calls act(i) for every eight numbers of rows of four.
template <class Act>
void for_all_numbers(const BodyRows& bodies, Act act) {
  for (std::uint32_t i = 0; i < 4 * bodies.count; i += lane_count) act(i);
}

/// Consecutive rows of four numbers.
struct RowsFrom {
  Real* first;
  Real* operator[](std::uint32_t lane) const { return first + 4 * lane; }
};

}  // namespace

void kick_by_forces(const BodyRows& bodies, Real h) {
  const Lanes half = Lanes::all(h / 2);
  for_all_numbers(bodies, [&](std::uint32_t i) {
    const Lanes kick = half * Lanes::load(bodies.acceleration + i);
    kick.store(bodies.kick + i);
  });
}

void kick_bodies(const BodyRows& bodies, bool first) {
  const Lanes half = Lanes::all(Real{1} / 2);
  for_all_numbers(bodies, [&](std::uint32_t i) {
    const Lanes velocity = Lanes::load(bodies.velocity + i);
    const Lanes kick = first ? Lanes::load(bodies.kick + i) : half * (velocity - Lanes::load(bodies.before + i));
    velocity.store(bodies.before + i);
    kick.store(bodies.kick + i);
    (velocity + kick).store(bodies.velocity + i);
  });
}

// The series are those of Motion (motion.cpp).
bool drift_bodies(const BodyRows& bodies, Real h) {
  const Lanes step = Lanes::all(h);
  const auto coefficient = [](Real nominator, Real denominator) { return Lanes::all(nominator / denominator); };
  std::uint32_t far = 0;
  for (std::uint32_t first = 0; first < bodies.count; first += lane_count) {
    const RowsFrom motion_rows{bodies.motion + 4 * first};
    Lanes velocity[4];
    Lanes motion[4];
    Lanes::gather(RowsFrom{bodies.velocity + 4 * first}, velocity);
    Lanes::gather(motion_rows, motion);
    const Lanes angle = Lanes::load(bodies.turn + first) + step * velocity[2];
    angle.store(bodies.turn + first);
    motion[0] = motion[0] + step * velocity[0];
    motion[1] = motion[1] + step * velocity[1];
    const Lanes z = angle * angle;
    Lanes odd = coefficient(-1, 39916800);
    odd = odd * z + coefficient(1, 362880);
    odd = odd * z - coefficient(1, 5040);
    odd = odd * z + coefficient(1, 120);
    odd = odd * z - coefficient(1, 6);
    motion[2] = angle + angle * z * odd;
    Lanes even = coefficient(1, 479001600);
    even = even * z - coefficient(1, 3628800);
    even = even * z + coefficient(1, 40320);
    even = even * z - coefficient(1, 720);
    even = even * z + coefficient(1, 24);
    even = even * z - coefficient(1, 2);
    motion[3] = z * even;
    far |= (coefficient(1, 16) < z).bits();
    Lanes::scatter(motion, motion_rows);
  }
  for_all_numbers(bodies, [&](std::uint32_t i) {
    (Lanes::load(bodies.velocity + i) + Lanes::load(bodies.kick + i)).store(bodies.velocity + i);
  });
  return far != 0;
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
