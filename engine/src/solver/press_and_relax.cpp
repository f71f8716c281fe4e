#include "solver/press_and_relax.h"

#include <limits>

#include "solver/scalar_contacts.h"

namespace impulse::inline IMPULSE_PRECISION {

void PressAndRelax::press(bool rigidly) {
  for (int sweep = 0; sweep < island_.sweeps; ++sweep) {
    if (!island_.joints.empty()) island_.joints.press(island_.h);
    ScalarContacts contacts(bodies_, motion_);
    if (rigidly) {
      contacts.press_rigidly(island_);
    } else {
      contacts.press(island_);
    }
  }
}

bool PressAndRelax::deepens(bool held) const {
  return ScalarContacts(bodies_, motion_).deepens(island_, not_felt, held);
}

/// Extra rigid iterations. In an impact, a soft contact penetrates by 1 - strength of the displacement in a sub-step,
/// and by what one iteration has not propagated: at 10 m/s that is centimetres. So contacts are solved rigidly until
/// none penetrates deeper in this sub-step.
int PressAndRelax::press_through() {
  int sweeps = 0;
  while (sweeps < island_.press_sweeps && deepens(false)) {
    if (sweeps == 0) {
      search_.begin(island_);
    } else {
      search_.go_on(island_, bodies_, changes_, true);
    }
    press(true);
    sweeps += island_.sweeps;
  }
  return sweeps;
}

void PressAndRelax::relax(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (!island_.joints.empty()) island_.joints.relax(island_.h);
    ScalarContacts(bodies_, motion_).relax(island_);
  }
}

/// After one iteration, bodies that friction rotates into the ground still approach it.
void PressAndRelax::relax_through() {
  for (int sweep = 0; sweep < island_.press_sweeps && deepens(true); ++sweep) {
    if (sweep == 0) {
      search_.begin(island_);
    } else {
      search_.go_on(island_, bodies_, changes_, false);
    }
    relax(1);
  }
}

void PressAndRelax::relax_until_bounded(const EnergyBound& bound, const std::vector<Velocity>& acceleration) {
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const auto excess = [&] { return bound.excess(bodies_, motion_, acceleration, rounding); };
  for (Descent descent(island_.more_sweeps); descent.goes_on(excess());) relax(1);
}

}  // namespace impulse::inline IMPULSE_PRECISION
