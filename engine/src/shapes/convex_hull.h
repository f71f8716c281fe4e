#pragma once

#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The corners of the convex hull, counter-clockwise from the leftmost, independent of the points' order. Omits corners
/// that are collinear with their neighbours up to rounding; collinear points give fewer than 3 corners.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

/// The width of a convex polygon (m): the least distance between two parallel lines that enclose it.
Real width(std::span<const Vec2> polygon);

/// The greatest distance between two of the points (m).
Real diameter(std::span<const Vec2> points);

}  // namespace impulse::inline IMPULSE_PRECISION
