#pragma once

#include <vector>

#include "bodies/body_set.h"
#include "solver/energy_bound.h"
#include "solver/island.h"
#include "solver/line_search.h"
#include "solver/local_sweeps.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m, penetration that an impact may add within a step: less than loads at rest may cause.
constexpr Real not_felt = static_cast<Real>(0.3) * tolerated_sink;

/// The two solves of a swept island's sub-step, before and after the drift: how often it is swept, contact after
/// contact. A blow goes through the whole island, until no contact gets deeper by what would be felt.
class PressAndRelax {
 public:
  /// `motion` is of each body since the start of the step; `changes` is storage, of each body; `search` and `local`
  /// are reused from island to island.
  PressAndRelax(BodySet& bodies, Island& island, const std::vector<Motion>& motion, std::vector<Velocity>& changes,
                LineSearch& search, LocalSweeps& local)
      : bodies_(bodies), island_(island), motion_(motion), changes_(changes), search_(search), local_(local) {}

  /// Solves with bias: velocities that correct positions too. `rigidly`: see ScalarContacts::press_rigidly().
  void press(bool rigidly);
  /// More of that, rigidly. Returns the number of sweeps.
  int press_through();
  /// Rigid contacts with friction.
  void relax(int sweeps);
  /// More of that.
  void relax_through();
  /// More of that, until the energy is bounded.
  void relax_until_bounded(const EnergyBound& bound, const std::vector<Velocity>& acceleration);

 private:
  bool deepens(bool held) const;
  /// More sweeps of the contacts near those that still get deeper.
  void sweep_locally(bool pressing);

  BodySet& bodies_;
  Island& island_;
  const std::vector<Motion>& motion_;
  std::vector<Velocity>& changes_;
  LineSearch& search_;
  LocalSweeps& local_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
