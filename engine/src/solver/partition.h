#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "bodies/force_field.h"
#include "islands/islands.h"
#include "solver/lanes/contact_lanes.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The islands of a step: bodies that must be stepped together, with their contacts and joints. Contacts without
/// points, or between bodies that cannot be pushed, belong to no island.
class Partition {
 public:
  /// Finds the islands of a step. If only contacts connect bodies, and the same ones as in the last step (as at rest),
  /// the islands are those of the last step.
  ///
  /// Bodies share an island if they are connected and both move, or belong to the same pile at rest. Springs and
  /// attractions connect them too.
  void split(const StepData& data);

  /// To be called when points of contacts changed within the step, so that the next step lists them again.
  void forget_points() { contact_changes_ = 0; }

  /// Changes whenever the islands may have changed.
  std::uint64_t version() const { return version_; }

  std::size_t size() const { return islands_.size(); }
  std::size_t body_count() const { return crowd_.size(); }
  std::span<const std::uint32_t> bodies(std::size_t island) const { return islands_.bodies(island); }
  /// In the order of the step's contacts.
  std::span<const Tie> contacts(std::size_t island) const { return contacts_.of(island); }
  /// The index of the island's first contact among those of all islands.
  std::size_t first_contact(std::size_t island) const { return contacts_.start[island]; }
  std::size_t contact_count() const { return contacts_.items.size(); }
  std::span<ActiveJoint* const> joints(std::size_t island) const { return joints_.of(island); }
  /// The forces on an island's bodies but for attractions.
  std::span<const Pull> pulls(std::size_t island) const { return pulls_.of(island); }
  /// Whether an acceleration by forces depends on positions or velocities of the island's bodies.
  bool varies(std::size_t island) const { return varies_[island] != 0; }
  /// Whether a pushable body of the contact has more than two contacts, as in a pyramid but not in a column.
  bool in_web(const Tie& tie) const { return crowd_[tie.a] > 2 || crowd_[tie.b] > 2; }

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

  bool nothing_changed(const StepData& data);
  void list_ties(const StepData& data);
  void split_anew(const StepData& data, bool only_contacts);
  void find_islands(const StepData& data);
  void find_varying(const StepData& data);

  std::uint64_t version_ = 0;
  bool only_contacts_ = false;  // tied bodies in the last step
  Islands islands_;
  std::uint64_t contact_changes_ = 0;     // when ties were listed
  std::uint64_t pile_changes_ = 0;        // of the bodies, when they were last split
  std::vector<std::uint32_t> first_of_;   // body of each pile at rest
  std::vector<std::uint8_t> kinds_;       // of bodies: whether they can be pushed, and move
  std::vector<std::uint8_t> last_kinds_;  // the same of the last step
  std::vector<Tie> tied_;                 // contacts that belong to an island
  std::vector<Tie> last_tied_;            // the same of the last step
  std::vector<std::uint8_t> crowd_;       // contacts of each body that can be pushed, up to 3
  ByIsland<Tie> contacts_;
  ByIsland<ActiveJoint*> joints_;
  std::vector<ActiveJoint*> all_joints_;
  ByIsland<Pull> pulls_;
  std::vector<Pull> all_pulls_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  // of bodies, coupled by forces
  std::vector<std::uint8_t> varying_;                           // by body: whether forces on it vary within the step
  std::vector<std::uint8_t> varies_;                            // by island
};

}  // namespace impulse::inline IMPULSE_PRECISION
