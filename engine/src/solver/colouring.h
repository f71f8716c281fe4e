#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/island.h"
#include "solver/lanes/contact_lanes.h"
#include "solver/partition.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Graph colouring of the contacts of an island: no two contacts of a colour share a body that can be pushed. Within a
/// colour they are sorted by kind. Contacts take the first colour that is free at both bodies, in order. Those with
/// fixed shapes are solved last, so that nothing pushes a body into them afterwards.
class Colouring {
 public:
  /// `width` contacts are solved at a time; the order of contacts does not depend on it.
  void assign(const Partition& parts, const Island& island, std::uint32_t width);

  /// All lanes of a kind, `width` by `width`.
  std::span<const Slot> lanes(LanesKind kind) const { return lanes_[static_cast<std::size_t>(kind)]; }
  /// In the order in which they are solved.
  std::span<const LanesRun> runs() const { return runs_; }
  /// The contacts of the island in the order in which the runs solve them.
  std::span<const Tie> order();

 private:
  struct Choice {
    Slot slot;
    std::uint16_t colour = 0;
    LanesKind kind = LanesKind::one;
  };
  void choose(const Partition& parts, const Island& island);
  void place();

  std::uint32_t width_ = 0;
  std::vector<std::uint64_t> taken_;  // colours used at each body
  std::vector<Choice> choices_;       // in the order of the contacts
  std::array<std::vector<Slot>, lanes_kinds> lanes_;
  std::vector<LanesRun> runs_;
  std::vector<std::uint32_t> next_;  // of each colour and kind: the count, then the next free lane
  std::vector<Tie> order_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
