#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/contact_lanes.h"
#include "solver.h"
#include "solvers/island.h"
#include "solvers/partition.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where a contact is solved in a pile.
struct Slot {
  Tie tie;
  std::uint16_t colour = 0;
  LanesKind kind = LanesKind::one;
  bool web = false;      // see ImpactRow
  std::uint32_t at = 0;  // lane among all those of its kind
};

/// Sorts the contacts of an island into colours, so that no two of a colour share a body that can be pushed, and into
/// kinds within each. A contact takes the first colour that is free at both bodies, in the order of the contacts. What
/// rests on fixed shapes comes last, so that nothing pushes it into them afterwards.
class Colouring {
 public:
  void assign(const Partition& parts, const Island& island);

  /// In the order of the contacts.
  std::span<const Slot> slots() const { return slots_; }
  /// In the order in which they are solved.
  std::span<const LanesRun> runs() const { return runs_; }
  /// How many times eight lanes of a kind the runs take.
  std::uint32_t count(LanesKind kind) const { return count_[static_cast<std::size_t>(kind)]; }
  /// The contacts of the island in the order in which the runs solve them.
  std::span<const Tie> order();

 private:
  static constexpr std::size_t kinds = 4;

  void choose(const Partition& parts, const Island& island);
  void place();

  std::vector<std::uint64_t> taken_;  // colours that each body's contacts have
  std::vector<Slot> slots_;
  std::vector<LanesRun> runs_;
  std::uint32_t count_[kinds] = {};
  std::vector<std::uint32_t> next_;  // how many of each colour and kind; then its next free lane
  std::vector<Tie> order_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
