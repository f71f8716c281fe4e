#include "solver/press_and_relax.h"

#include <limits>

#include "solver/scalar_contacts.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Where an impulse goes back and forth between contacts, a sweep leaves all but 1 or 2 % of it, and a line through the
/// impulses of the whole island does not see one place. What `patience` sweeps have not solved is over-relaxed.
constexpr Real over_relaxation = static_cast<Real>(1.5);
constexpr int patience = 6;

}  // namespace

void PressAndRelax::press() {
  for (int sweep = 0; sweep < island_.sweeps; ++sweep) {
    if (!island_.joints.empty()) island_.joints.press(island_.h);
    ScalarContacts(bodies_, motion_).press(island_);
  }
}

void PressAndRelax::press_rigidly(Real by) {
  for (int sweep = 0; sweep < island_.sweeps; ++sweep) {
    if (!island_.joints.empty()) island_.joints.press(island_.h);
    ScalarContacts(bodies_, motion_).press_rigidly(island_, by);
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
    press_rigidly(sweeps < patience ? Real{1} : over_relaxation);
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
