#pragma once

#include <cstdint>
#include <span>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a line or point represents; the implementation of DebugDraw chooses the colour.
enum class DrawRole : std::uint8_t { fixed, kinematic, awake, asleep, joint, contact };

/// The drawing functions that World::debug_draw calls. All coordinates are in the world frame, in m. These callbacks
/// may create, remove and destroy bodies; the change takes effect when debug_draw returns.
class DebugDraw {
 public:
  DebugDraw() = default;
  DebugDraw(const DebugDraw&) = delete;
  DebugDraw& operator=(const DebugDraw&) = delete;
  virtual ~DebugDraw() = default;

  /// Convex, counter-clockwise.
  virtual void polygon(std::span<const Vec2> corners, DrawRole role) = 0;
  /// `axis` has unit length and rotates with the body.
  virtual void circle(Vec2 center, Real radius, Vec2 axis, DrawRole role) = 0;
  virtual void segment(Vec2 from, Vec2 to, DrawRole role) = 0;
  virtual void point(Vec2 at, DrawRole role) = 0;
};

}  // namespace impulse::inline IMPULSE_PRECISION
