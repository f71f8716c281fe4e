#include "solvers/motion.h"

#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// The angle up to which the series below leave out less than 1e-17 of themselves: most turns of one step are smaller.
constexpr Real small_turn = static_cast<Real>(.25);

// Taylor's series of sine, and of cosine - 1 without its cancellation.
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
  if (std::abs(turn) <= small_turn) return small_sine_and_drop(turn, sine, drop);
  // cos - 1 = -2 sin^2(half): no cancellation either.
  const SinCos half = sin_cos(turn / 2);
  sine = 2 * half.sin * half.cos;
  drop = -2 * half.sin * half.sin;
}

void place(BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
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
    bodies.pose[i].q = Rotation(bodies.angle[i]);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
