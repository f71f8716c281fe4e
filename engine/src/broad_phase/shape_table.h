#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "narrow_phase/lanes/manifolds.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a part is to those who collide it.
enum class ShapeKind : std::uint8_t { box, disc, other };

/// The parts of all bodies that are in the world and awake, sorted by (body, part): what the search of contacts asks of
/// them, put together once a step, so that it need not visit the bodies for every pair.
class ShapeTable {
 public:
  /// As the bodies stand and move now, but for those of piles at rest: these stay as they were when they came to rest,
  /// a tremor away. Bounds are grown by what the margin lets a body reach.
  void update(const BodySet& bodies, const Margin& margin);
  /// Those as well, if they are of these pairs.
  void update(const BodySet& bodies, const Margin& margin, std::span<const Pair> pairs);
  /// Bodies may change their velocities within the step by these (m/s, of each body): those above 0 reach farther.
  void grow(const BodySet& bodies, const Margin& margin, std::span<const Real> knocks);

  std::span<const Proxy> proxies() const { return proxies_; }
  /// Changes whenever these are others than before.
  std::uint64_t version() const { return version_; }
  std::span<const ShapeRecord> records() const { return records_; }
  ShapeKind kind(std::size_t i) const { return still_[i].kind; }
  const Part& part(std::size_t i) const { return *still_[i].part; }
  Real restitution(std::size_t i) const { return still_[i].restitution; }
  /// Whether the bounds of two overlap only because one of them is a slanted box that fills little of its own: they are
  /// apart along one of its sides by more than both may grow.
  bool apart(std::size_t i, std::size_t j) const {
    bool found = false;
    if (slanted_[i] != 0) found |= beside(i, j);
    if (slanted_[j] != 0) found |= beside(j, i);
    return found;
  }
  bool some_slanted() const { return some_slanted_; }    // some box is
  Real fastest() const { return fastest_; }              // m/s, no point of any part goes faster
  bool several_parts() const { return several_parts_; }  // some body has

 private:
  /// What does not change while the part is in the world.
  struct Still {
    const Part* part;
    Vec2 centroid;
    Rotation turn;  // of a box in its body
    Vec2 size;      // as in ShapeRecord
    Real restitution;
    ShapeKind kind;
  };
  void list(const BodySet& bodies);
  bool beside(std::size_t box, std::size_t other) const;
  void place(std::size_t i, const BodySet& bodies, const Margin& margin, Real knock);

  std::vector<Still> still_;
  std::vector<Proxy> proxies_;
  std::vector<ShapeRecord> records_;
  std::vector<std::uint8_t> slanted_;  // whether each is a box that fills little of its bounds
  std::vector<Real> grown_by_;         // m, each one's bounds
  bool some_slanted_ = false;
  Real fastest_ = 0;
  bool several_parts_ = false;
  std::uint64_t version_ = 0;
  std::uint64_t part_changes_ = ~std::uint64_t{0};  // of the bodies, when they were last listed
  std::uint64_t sleep_changes_ = ~std::uint64_t{0};
  std::uint64_t pile_changes_ = ~std::uint64_t{0};
};

}  // namespace impulse::inline IMPULSE_PRECISION
