#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "narrow_phase/lanes/manifolds.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How a part is collided.
enum class ShapeKind : std::uint8_t { box, disc, other };

/// The parts of all bodies that are in the world and awake, sorted by (body, part): the data that the contact search
/// needs, gathered once a step, so that it need not visit the bodies for every pair.
class ShapeTable {
 public:
  /// Brings the table up to date, except for bodies of piles at rest (BodySet::pile), which have hardly moved since.
  /// Bounds are grown by the margin.
  void update(const BodySet& bodies, const Margin& margin);
  /// Updates the bodies of piles at rest that occur in these pairs.
  void update(const BodySet& bodies, const Margin& margin, std::span<const Pair> pairs);
  /// Grows the bounds of bodies whose velocity may change within the step; `impact_changes` (m/s) has an entry for each
  /// body, 0 for no change.
  void grow(const BodySet& bodies, const Margin& margin, std::span<const Real> impact_changes);

  std::span<const Proxy> proxies() const { return proxies_; }
  /// Changes whenever the list of proxies changes, apart from their motion.
  std::uint64_t version() const { return version_; }
  std::span<const ShapeRecord> records() const { return records_; }
  ShapeKind kind(std::size_t i) const { return fixed_[i].kind; }
  const Part& part(std::size_t i) const { return *fixed_[i].part; }
  Real restitution(std::size_t i) const { return fixed_[i].restitution; }
  /// Whether two parts are certainly too far apart although their bounds overlap: one of them is a slanted box that
  /// fills little of its bounds, and one of its sides separates the two.
  bool apart(std::size_t i, std::size_t j) const {
    bool found = false;
    if (slanted_[i] != 0) found |= beside(i, j);
    if (slanted_[j] != 0) found |= beside(j, i);
    return found;
  }
  bool some_slanted() const { return some_slanted_; }
  Real fastest() const { return fastest_; }              // m/s, bound of the speed of any point
  bool several_parts() const { return several_parts_; }  // of some body

 private:
  /// The data that stay the same while the part is in the world.
  struct FixedData {
    const Part* part;
    Vec2 centroid;
    Rotation turn;  // of a box in its body
    Vec2 size;      // as in ShapeRecord
    Real restitution;
    ShapeKind kind;
  };
  void list(const BodySet& bodies);
  bool beside(std::size_t box, std::size_t other) const;
  void place(std::size_t i, const BodySet& bodies, const Margin& margin, Real impact_change);

  std::vector<FixedData> fixed_;
  std::vector<Proxy> proxies_;
  std::vector<ShapeRecord> records_;
  std::vector<std::uint8_t> slanted_;  // 1 for a box that fills little of its bounds
  std::vector<Real> grown_by_;         // m, of each one's bounds
  bool some_slanted_ = false;
  Real fastest_ = 0;
  bool several_parts_ = false;
  std::uint64_t version_ = 0;
  std::uint64_t part_changes_ = ~std::uint64_t{0};  // of the bodies, at the last list()
  std::uint64_t sleep_changes_ = ~std::uint64_t{0};
  std::uint64_t pile_changes_ = ~std::uint64_t{0};
};

}  // namespace impulse::inline IMPULSE_PRECISION
