#include "solver/press_and_relax.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "solver/scalar_contacts.h"

namespace impulse::inline IMPULSE_PRECISION {

void PressAndRelax::press(bool rigidly) {
  for (int sweep = 0; sweep < island_.sweeps; ++sweep) {
    if (!island_.joints.empty()) island_.joints.press(island_.h);
    ScalarContacts contacts(bodies_, motion_);
    if (rigidly) {
      contacts.press_rigidly(island_, island_.acting);
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
    sweep_locally(true);
    sweeps += island_.sweeps;
  }
  return sweeps;
}

void PressAndRelax::relax(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (!island_.joints.empty()) island_.joints.relax(island_.h);
    ScalarContacts(bodies_, motion_).relax(island_, island_.acting);
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
    sweep_locally(false);
  }
}

void PressAndRelax::sweep_locally(bool pressing) {
  constexpr std::size_t most = 20;    // sweeps; more of them gain less than one of the whole island,
  constexpr std::size_t cost = 2;     // and they may take as long as this many of that
  constexpr std::size_t between = 4;  // looks whether they have sufficed
  if (!island_.joints.empty()) return;
  ScalarContacts contacts(bodies_, motion_);
  if (!local_.find(island_, contacts, motion_.size(), not_felt, !pressing)) return;
  const std::span<const std::uint32_t> rows = local_.rows();
  const std::size_t sweeps = std::min(most, cost * island_.rows.size() / rows.size());
  for (std::size_t sweep = 1; sweep <= sweeps; ++sweep) {
    if (pressing) {
      contacts.press_rigidly(island_, rows);
    } else {
      contacts.relax(island_, rows);
    }
    const bool look = sweep % between == 0 && sweep < sweeps;
    if (look && std::none_of(rows.begin(), rows.end(), [&](std::uint32_t row) {
          return contacts.deepens(island_, island_.rows[row], not_felt, !pressing);
        })) {
      return;
    }
  }
}

void PressAndRelax::relax_until_bounded(const EnergyBound& bound, const std::vector<Velocity>& acceleration) {
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const auto excess = [&] { return bound.excess(bodies_, motion_, acceleration, rounding); };
  for (Descent descent(island_.more_sweeps); descent.goes_on(excess());) relax(1);
}

}  // namespace impulse::inline IMPULSE_PRECISION
