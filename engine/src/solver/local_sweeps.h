#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/island.h"
#include "solver/scalar_contacts.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where an impact is still to be solved: of the 1500 contacts of a heap that falls, 2 to 40 get deeper when all have
/// been swept 66 times. Sweeps over their neighbourhood alone cost a tenth and pass on what they cannot bear to the
/// sweeps of the whole island, which must follow.
class LocalSweeps {
 public:
  /// Lists the contacts that get deeper, those of their bodies, and those of what these bodies touch. False if none
  /// does, or if that would be most of the island. `in_step` and `held`: see ScalarContacts::deepens().
  bool find(const Island& island, const ScalarContacts& contacts, std::size_t bodies, Real in_step, bool held);
  /// Indices of the rows listed, in the island's order.
  std::span<const std::uint32_t> rows() const { return rows_; }

 private:
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint8_t> ring_;  // of each body: 1 if a contact of it gets deeper, 2 if it touches one of those
};

}  // namespace impulse::inline IMPULSE_PRECISION
