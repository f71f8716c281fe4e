#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "islands.h"
#include "solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bodies that must be stepped together, with the contacts and joints among them. Contacts without points, or between
/// bodies that nothing can push, belong to no island.
class Partition {
 public:
  /// Bodies share an island if something ties them and both move; `together` puts them all into one.
  void split(const StepData& data, bool together);

  std::size_t size() const { return islands_.size(); }
  std::span<const std::uint32_t> bodies(std::size_t island) const { return islands_.bodies(island); }
  /// Indices into the contacts of the step, in their order.
  std::span<const std::uint32_t> contacts(std::size_t island) const { return contacts_.of(island); }
  /// Where the island's contacts begin among those of all islands.
  std::size_t first_contact(std::size_t island) const { return contacts_.start[island]; }
  std::size_t contact_count() const { return contacts_.items.size(); }
  std::span<ActiveJoint* const> joints(std::size_t island) const { return joints_.of(island); }
  /// Whether a body that can be pushed has more than two contacts, as in a pyramid and not in a column.
  bool in_web(std::uint32_t body) const { return crowd_[body] > 2; }

 private:
  /// Items sorted by island, in their own order within each.
  template <class Item>
  struct ByIsland {
    std::vector<Item> items;
    std::vector<std::size_t> start;  // of each island, and the end
    std::vector<std::size_t> next;   // free place of each island while items are put there

    std::span<const Item> of(std::size_t island) const {
      return std::span(items).subspan(start[island], start[island + 1] - start[island]);
    }
    template <class Source, class IslandOf>
    void sort(const Source& source, std::size_t islands, IslandOf island_of);
  };

  Islands islands_;
  std::vector<std::uint32_t> tied_;  // contacts that belong to an island
  std::vector<std::uint8_t> crowd_;  // contacts of each body that can be pushed, up to 3
  ByIsland<std::uint32_t> contacts_;
  ByIsland<ActiveJoint*> joints_;
  std::vector<ActiveJoint*> all_joints_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
