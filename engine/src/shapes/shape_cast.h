#pragma once

#include <optional>

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where `moving`, which starts at a pose and moves by `by` without rotating, first touches `other`: the share of the
/// way, and point and normal of `other`, world frame. The normal is 0 if they overlap at the start. Segments of a chain
/// are hit only from their free side.
std::optional<RayHit> shape_cast(const Shape& moving, const Pose& start, Vec2 by, const Shape& other, const Pose& pose);

}  // namespace impulse::inline IMPULSE_PRECISION
