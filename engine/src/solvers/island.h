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
  int sweeps = 1;  // joints and contacts, or joints and their stops, are solved in turn
  Real h = 0;
  Softness soft, stiff;   // between movable bodies; against what cannot move
  bool bounces = false;   // some contact has restitution
  bool settling = false;  // begins at rest: its loads are found at once

  const Softness& softness(const ContactRow& row) const {
    return row.mass_a.m == 0 || row.mass_b.m == 0 ? stiff : soft;
  }

  /// Sets h and the softness that goes with it: a frequency of 1/(8 h), the stiffest that does not jitter, and twice
  /// that against what cannot move. A load then rests at a depth of load / (2 m_eff w^2), half of the usual, because
  /// half of each sub-step's impulse is already given when the contact is solved.
  void cut(Real dt, int into);
};

/// How many sub-steps an island needs so that its own weight presses it no deeper than tolerated, at most 32 and the
/// settings' number at least. From masses alone: an estimate from the impulses would flicker with them, and a stack
/// would topple while it is low.
int substeps_for(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration,
                 const Settings& settings);

}  // namespace impulse::inline IMPULSE_PRECISION
