#pragma once

#include <cstdint>

#include "broad_phase/broad_phase.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// All that colliding needs to know of one box or disc as it stands, in rows of four numbers.
struct ShapeRecord {
  Vec2 position;   // of its body's centre of mass, world frame
  Vec2 offset;     // box: from there to its centre, world frame; disc: the same, body frame
  Rotation turn;   // box: of its own frame; disc: of the body
  Vec2 size;       // box: half extents; disc: radius, 0
  Vec2 velocity;   // m/s, of the centre of mass
  Real rim = 0;    // m/s, the fastest that turning moves a point of the body
  Real knock = 0;  // m/s, by which the velocity may change within the step
};

/// What a pair of shapes reports (see Manifold), seen from its bodies, in rows of four numbers. World frame.
struct PairPoints {
  Real normal[2];      // unit, from a to b
  Real separation[2];  // m, of each point
  Real arms[2][4];     // of each point: from the centre of mass of a, then of b
  std::uint32_t feature[2];
  std::int32_t count;
};

/// Some pairs of shapes: pairs[items[i]] for i below count. They are given points up to the gap that the two may close:
/// distance + time (|velocity of b - that of a| + rims + knocks).
struct PairBatch {
  const ShapeRecord* shapes;
  const Pair* pairs;
  const std::uint32_t* items;
  std::uint32_t count;
  Real distance;  // m
  Real time;      // s
};

/// The vectorised twins of box_box, circle_box and circle_circle (see collide/): the same bits in found[item]. Items
/// that need a second look are written to `left` instead, to be given to the twin, and the end of their list is
/// returned; there must be room for all.
using CollidePairs = std::uint32_t*(const PairBatch& batch, PairPoints* found, std::uint32_t* left);

/// Writes those items that may meet faster than their gaps, and than the batch's distance, allow within its time, and
/// returns the end of their list; there must be room for all. An item with a negative count has no points in `found`:
/// it is written if it may go that fast in any direction.
using FindFast = std::uint32_t*(const PairBatch& batch, const PairPoints* found, const std::int8_t* counts,
                                std::uint32_t* to);

}  // namespace impulse::inline IMPULSE_PRECISION
