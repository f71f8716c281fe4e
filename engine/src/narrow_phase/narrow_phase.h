#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "narrow_phase/collide.h"
#include "narrow_phase/lanes/manifolds.h"
#include "narrow_phase/margin.h"
#include "narrow_phase/shape_table.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Collides many pairs of shapes at once: boxes and discs by kernels; all others, and those a kernel cannot decide, by
/// collide(). Both give the same bits.
class NarrowPhase {
 public:
  /// Writes the contact points of pairs[item] to found[item], for each item.
  void collide(const BodySet& bodies, const ShapeTable& shapes, const Margin& margin, std::span<const Pair> pairs,
               std::span<const std::uint32_t> items, PairPoints* found);

 private:
  const NarrowPhaseKernels* kernels_ = &narrow_phase_kernels();
  std::array<std::vector<std::uint32_t>, 5> bins_;
};

/// A manifold in the form that the kernels write; the centres are those of the bodies.
PairPoints points_of(const Manifold& manifold, Vec2 center_a, Vec2 center_b);

}  // namespace impulse::inline IMPULSE_PRECISION
