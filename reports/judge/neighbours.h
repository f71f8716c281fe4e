#pragma once

#include <optional>
#include <span>
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
  /// velocities before or after would give, and what the scene's forces add, F/m dt^2. The step is longer by the stated
  /// lead of impacts. What such a neighbour strikes may be faster between two blows than before and after: its velocity
  /// changes by at most (1 + e) <= 2 times that at which they meet, and its spin by m r / I times that.
  /// Found once for all who ask, as long as memory allows; from one thread at a time, and valid until the next call.
  std::span<const BodyGap> in_step(std::size_t moment) const;

 private:
  /// Adds to `reach` what blows of these pairs may add; returns whether there is any.
  bool after_blows(std::span<const BodyGap> met, std::span<const BodyState> then, std::span<const BodyState> now,
                   double dt, std::vector<double>& reach) const;

  std::vector<BodyGap> find(std::size_t moment) const;

  const Trace& trace_;
  AppliedForces forces_;
  double contact_gap_;
  double lead_;                // s
  std::vector<double> radii_;  // m, about the centre of mass; infinite for a half-space
  Overlap overlap_;
  mutable std::vector<std::optional<std::vector<BodyGap>>> known_;  // by moment
  mutable std::vector<BodyGap> last_;                               // found after there was room for it
  mutable std::size_t room_;                                        // for gaps in known_
};

}  // namespace plumb
