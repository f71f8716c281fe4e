#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/shape_table.h"
#include "solver/lanes/kernels.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Collides many pairs of shapes at once: boxes and discs eight at a time, by kernels; all others, and what a kernel
/// leaves, by the colliders of collide.h. Both give the same bits.
class NarrowPhase {
 public:
  /// Writes what pairs[item] reports to found[item], for each of the items.
  void collide(const BodySet& bodies, const ShapeTable& shapes, const Margin& margin, std::span<const Pair> pairs,
               std::span<const std::uint32_t> items, PairPoints* found);

 private:
  const Kernels* kernels_ = &kernels();
  std::array<std::vector<std::uint32_t>, 5> bins_;
};

/// What two shapes report, as the kernels write it.
PairPoints points_of(const Manifold& manifold, Vec2 center_a, Vec2 center_b);

}  // namespace impulse::inline IMPULSE_PRECISION
