#pragma once

#include <cstdint>
#include <span>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a line or point stands for; the one who draws chooses its colour.
enum class DrawRole : std::uint8_t { fixed, kinematic, awake, asleep, joint, contact };

/// What World::debug_draw draws with. All coordinates are of the world, in m. Bodies may be created, removed and
/// destroyed from here; it takes effect when debug_draw returns.
class DebugDraw {
 public:
  DebugDraw() = default;
  DebugDraw(const DebugDraw&) = delete;
  DebugDraw& operator=(const DebugDraw&) = delete;
  virtual ~DebugDraw() = default;

  /// Convex, counter-clockwise.
  virtual void polygon(std::span<const Vec2> corners, DrawRole role) = 0;
  /// `axis`, of unit length, turns with the body.
  virtual void circle(Vec2 center, Real radius, Vec2 axis, DrawRole role) = 0;
  virtual void segment(Vec2 from, Vec2 to, DrawRole role) = 0;
  virtual void point(Vec2 at, DrawRole role) = 0;
};

}  // namespace impulse::inline IMPULSE_PRECISION
