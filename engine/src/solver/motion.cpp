#include "solver/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The angle up to which the series below have a relative error below 1e-17: most rotations in one step are smaller.
constexpr Real small_turn = static_cast<Real>(.25);

// Taylor series of sine, and of cosine - 1 without cancellation.
void small_sine_and_drop(Real angle, Real& sine, Real& drop) {
  const Real z = angle * angle;
  Real odd = -1 / static_cast<Real>(39916800);  // -1/11!
  odd = odd * z + 1 / Real{362880};
  odd = odd * z - 1 / Real{5040};
  odd = odd * z + 1 / Real{120};
  odd = odd * z - 1 / Real{6};
  sine = angle + angle * z * odd;
  Real even = 1 / static_cast<Real>(479001600);  // 1/12!
  even = even * z - 1 / Real{3628800};
  even = even * z + 1 / Real{40320};
  even = even * z - 1 / Real{720};
  even = even * z + 1 / Real{24};
  even = even * z - 1 / Real{2};
  drop = z * even;
}

}  // namespace

void Motion::turn_by(Real angle) {
  if (angle == 0) return;
  turn += angle;
  // Then all terms after the first of either series are below rounding, as for all bodies at rest.
  if (const Real z = turn * turn; z < std::numeric_limits<Real>::epsilon()) {
    sine = turn;
    drop = -z / 2;
    return;
  }
  if (std::abs(turn) <= small_turn) return small_sine_and_drop(turn, sine, drop);
  // cos - 1 = -2 sin^2(half): no cancellation either.
  const SinCos half = sin_cos(turn / 2);
  sine = 2 * half.sin * half.cos;
  drop = -2 * half.sin * half.sin;
}

void place(BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion) {
  constexpr std::size_t handful = 32;
  std::array<Real, handful> angles, cosines, sines;
  std::array<std::size_t, handful> turned;
  for (std::size_t first = 0; first < bodies.size(); first += handful) {
    const std::size_t end = std::min(first + handful, bodies.size());
    std::uint32_t count = 0;
    for (std::size_t i = first; i < end; ++i) {
      const Motion& by = motion[i];
      if (by.d == Vec2{} && by.turn == 0) {
        bodies.pose[i] = start[i];
        continue;
      }
      const Vec2 wanted = by.d + bodies.remainder[i];
      const Vec2 p = start[i].p + wanted;
      bodies.remainder[i] = wanted - (p - start[i].p);
      bodies.pose[i].p = p;
      if (by.turn == 0) continue;
      bodies.angle[i] += by.turn;
      angles[count] = bodies.angle[i];
      turned[count++] = i;
    }
    if (count == 0) continue;
    for (std::uint32_t k = count; k % most_angles_at_once != 0; ++k) angles[k] = 0;  // the kernel reads whole registers
    solver_kernels().turn_to_angles(angles.data(), count, cosines.data(), sines.data());
    for (std::uint32_t k = 0; k < count; ++k) bodies.pose[turned[k]].q = {cosines[k], sines[k]};
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
