#pragma once

#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The corners of the convex hull, counter-clockwise from the leftmost, whatever the order of the points. Corners that
/// stand out from the line of their neighbours by rounding only are left out; all points on one line give fewer than 3.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

/// The least distance between two parallel lines with all vertices of a convex polygon between them.
Real width(std::span<const Vec2> polygon);

/// The greatest distance between two points.
Real diameter(std::span<const Vec2> points);

}  // namespace impulse::inline IMPULSE_PRECISION
