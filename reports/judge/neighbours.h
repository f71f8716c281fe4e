#pragma once

#include <vector>

#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

/// Which bodies may touch within a step, from the scene's shapes and the states alone, whatever contacts the engine
/// reports. The scene and the trace must outlive it.
class Neighbours {
 public:
  Neighbours(const Scene&, const Trace&, const Stepping&);

  /// The parts whose gap at the start of the step that ends at `moment`, >= 1, is at most the gap of a contact at rest
  /// plus the distance that both bodies may move within the step: the larger of what they did move and what their
  /// velocities before or after would give, and what the scene's forces add, F/m dt^2.
  std::vector<BodyGap> in_step(std::size_t moment) const;

 private:
  const Trace& trace_;
  AppliedForces forces_;
  double contact_gap_;
  std::vector<double> radii_;  // m, about the centre of mass; infinite for a half-space
  Overlap overlap_;
};

}  // namespace plumb
