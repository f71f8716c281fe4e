#pragma once

#include <cstdint>

#include "broad_phase/broad_phase.h"
#include "core/instruction_set.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What the kernels need to know of a posed box or disc, in rows of four numbers.
struct ShapeRecord {
  Vec2 position;           // of its body's centre of mass, world frame
  Vec2 offset;             // box: from there to its centre, world frame; disc: the same, body frame
  Rotation turn;           // box: of its own frame; disc: of the body
  Vec2 size;               // box: half extents; disc: radius, 0
  Vec2 velocity;           // m/s, of the centre of mass
  Real rim = 0;            // m/s, the greatest speed at which rotation moves a point of the body
  Real impact_change = 0;  // m/s, predicted change of velocity by impacts within the step
};

/// The contact points of a pair of shapes (see Manifold), relative to the bodies, in rows of four numbers; world frame.
struct PairPoints {
  Real normal[2];      // unit, from a to b
  Real separation[2];  // m, of each point
  Real arms[2][4];     // of each point: from the centre of mass of a, then of b
  std::uint32_t feature[2];
  std::int32_t count;
};

/// A batch of pairs of shapes: pairs[items[i]] for i below count. They get points up to a gap of
/// distance + time (|velocity of b - that of a| + rims + impact changes).
struct PairBatch {
  const ShapeRecord* shapes;
  const Pair* pairs;
  const std::uint32_t* items;
  std::uint32_t count;
  Real distance;  // m
  Real time;      // s
};

/// The vectorised twins of box_box, circle_box and circle_circle (see collide.h): they write the same bits to
/// found[item]. Items that they cannot decide are written to `left`, for the twin to collide; returns the end of that
/// list, which needs room for all items.
using CollidePairs = std::uint32_t*(const PairBatch& batch, PairPoints* found, std::uint32_t* left);

/// Lists the items whose shapes may approach farther within the batch's time than both their gap and the batch's
/// distance; returns the end of the list, which needs room for all. `found` has no points for an item with a negative
/// count: such an item is listed if it may be that fast in any direction.
using FindFast = std::uint32_t*(const PairBatch& batch, const PairPoints* found, const std::int8_t* counts,
                                std::uint32_t* to);

/// The kernels of the narrow phase; they give the bits of their scalar twins.
struct NarrowPhaseKernels {
  CollidePairs* collide_boxes;
  CollidePairs* collide_discs;
  CollidePairs* collide_disc_with_box;  // the disc is the first of each pair
  CollidePairs* collide_box_with_disc;
  FindFast* find_fast;
};
const NarrowPhaseKernels& narrow_phase_kernels(InstructionSet set = fastest_instruction_set());

}  // namespace impulse::inline IMPULSE_PRECISION
