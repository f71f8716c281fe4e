#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "body_set.h"
#include "impulse/settings.h"
#include "solvers/impacts.h"
#include "solvers/island_joints.h"
#include "solvers/softness.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A sub-step is so short that an island would sink by this much (m) at most before the standing offset lifts it.
constexpr Real tolerated_sink = static_cast<Real>(0.0005);

/// One island of `accurate` for the length of a step.
struct Island {
  std::span<const std::uint32_t> bodies;
  std::span<ImpactRow> rows;
  IslandJoints joints;
  int substeps = 1;
  int sweeps = 1;       // joints and contacts, or joints and their stops, are solved in turn
  int more_sweeps = 0;  // that relaxation may take until it gains no energy
  Real h = 0;
  struct Softnesses {
    Softness movable, fixed;  // between movable bodies; against what cannot move
  };
  Softnesses column, web;
  bool ideal = false;     // its joints are all that could add energy, and they must not
  bool bounces = false;   // some contact has restitution
  bool settling = false;  // begins at rest: its loads are found at once

  const Softness& softness(const ImpactRow& row) const {
    const Softnesses& of = row.web ? web : column;
    return row.mass_a.m == 0 || row.mass_b.m == 0 ? of.fixed : of.movable;
  }

  /// Sets h and the softness that goes with it: the highest frequency that does not jitter, 1/(8 h) in a column, and
  /// twice that against what cannot move. In the web of a pyramid, where each body pushes several that push back within
  /// the same sweep, it is 1/(12 h): at 1/(8 h) one of base 20 shakes itself up to .08 m/s and is not still after 25 s,
  /// at 1/(10 h) after 6.6 s, at 1/(12 h) after 3.3 s. A load then rests at a depth of load / (2 m_eff w^2), half of
  /// the usual, because half of each sub-step's impulse is already given when the contact is solved.
  void cut(Real dt, int into);
  /// Impulses of a whole step to those of one of n sub-steps, and back.
  void share(Real by);
};

/// How many sub-steps an island needs so that its own weight presses it no deeper than tolerated, at most 32 and the
/// settings' number at least. From masses alone: an estimate from the impulses would flicker with them, and a stack
/// would topple while it is low.
int substeps_for(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration,
                 const Settings& settings);

/// How often beyond its sweeps an island may be relaxed: not at all without a blow, nor where it would be dear.
int more_sweeps_for(const Island& island, const BodySet& bodies);

}  // namespace impulse::inline IMPULSE_PRECISION
