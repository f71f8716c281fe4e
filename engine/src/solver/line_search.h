#pragma once

#include <array>
#include <vector>

#include "bodies/body_set.h"
#include "solver/island.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Finds contact impulses where sweeps alone would need as many as the ratio of the masses: each hands the impulse of a
/// heavy body through a light one to the ground by a share of that ratio.
///
/// Without friction, contact impulses J >= 0 are a solution if they make the energy least,
///
///   E(J) = sum over the bodies of m v(J)^2 / 2 + J . bias
///
/// with `bias` the velocity at which a point should part. Along a line of impulses E is a parabola, so its lowest point
/// is known, and no step taken here increases E. Changes of velocity (`kicks`, `changes`) are arrays for all bodies, of
/// which only those of the island are used.
class LineSearch {
 public:
  /// At the end of a sub-step, on its impulses, with which the next one begins. That guess is wrong after a blow, which
  /// stopped a body and is not what it rests with, and where a body leaves: it would add energy to free flight. Then it
  /// goes back towards the guess of this sub-step (see ScalarContacts::halve), and if that would too, towards none.
  void temper(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration,
              std::vector<Velocity>& kicks, std::vector<Velocity>& changes);

  /// Before the first of some sweeps.
  void begin(const Island& island);
  /// Between two of them: goes on in the direction of all sweeps so far, conjugate to what they solved (nonsmooth
  /// nonlinear conjugate gradients: M. Silcowitz, S. Niebe and K. Erleben, A nonsmooth nonlinear conjugate gradient
  /// method for interactive contact force problems, 2010), but not beyond the lowest energy, nor so far that a point
  /// would pull. A sweep must follow, which enforces the limit of friction. `pressing`: the sweeps are press_rigidly().
  void go_on(const Island& island, BodySet& bodies, std::vector<Velocity>& changes, bool pressing);

 private:
  /// N s, along normal and tangent, of each point of each acting row.
  using Impulses = std::vector<std::array<Vec2, 2>>;

  static void list(const Island& island, Impulses& impulses);
  static void spread(const Island& island, const Impulses& impulses, std::vector<Velocity>& changes);

  Impulses last_, direction_;
  Real change_ = 0;  // squared norm of the last sweep's change
};

}  // namespace impulse::inline IMPULSE_PRECISION
