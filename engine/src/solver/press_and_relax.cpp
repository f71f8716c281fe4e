#include "solver/press_and_relax.h"

#include <limits>

#include "solver/scalar_contacts.h"

namespace impulse::inline IMPULSE_PRECISION {

/// As one system, if the island is to be. A sweep must follow: it rounds at each contact, not by the largest of them.
bool PressAndRelax::solve(ContactSystem::Stage stage) {
  return island_.direct && storage_.system.solve(island_, stage, bodies_, motion_);
}

void PressAndRelax::press(bool rigidly) {
  using enum ContactSystem::Stage;
  const bool solved = solve(rigidly ? press_rigid : press_soft);
  for (int sweep = 0; sweep < (solved ? 1 : island_.sweeps); ++sweep) {
    if (!island_.joints.empty()) island_.joints.press(island_.h);
    ScalarContacts contacts(bodies_, motion_);
    if (rigidly) {
      contacts.press_rigidly(island_);
    } else {
      contacts.press(island_);
    }
  }
}

/// Whether a contact penetrates deeper in this sub-step than its share of what is not felt. `held`: without the points
/// that relax skips.
bool PressAndRelax::deepens(bool held) const {
  return ScalarContacts(bodies_, motion_).deepening(island_, held) * static_cast<Real>(island_.substeps) > not_felt;
}

/// Extra rigid iterations. In an impact, a soft contact penetrates by 1 - strength of the displacement in a sub-step,
/// and by what one iteration has not propagated: at 10 m/s that is centimetres. So contacts are solved rigidly until
/// none penetrates deeper in this sub-step.
int PressAndRelax::press_through() {
  int sweeps = 0;
  while (sweeps < island_.press_sweeps && deepens(false)) {
    if (sweeps == 0) {
      storage_.search.begin(island_);
    } else {
      storage_.search.go_on(island_, bodies_, motion_, changes_, true);
    }
    press(true);
    sweeps += island_.sweeps;
  }
  return sweeps;
}

void PressAndRelax::relax(int sweeps) {
  const bool solved = solve(ContactSystem::Stage::relax);
  for (int sweep = 0; sweep < (solved ? 1 : sweeps); ++sweep) {
    if (!island_.joints.empty()) island_.joints.relax(island_.h);
    ScalarContacts(bodies_, motion_).relax(island_);
  }
}

/// After one iteration, bodies that friction rotates into the ground still approach it.
void PressAndRelax::relax_through() {
  for (int sweep = 0; sweep < island_.press_sweeps && deepens(true); ++sweep) {
    if (sweep == 0) {
      storage_.search.begin(island_);
    } else {
      storage_.search.go_on(island_, bodies_, motion_, changes_, false);
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
