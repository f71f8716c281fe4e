#pragma once

#include <cstdint>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Cosines and sines of so many angles, each to the bit what sin_cos makes of it. Eight at a time: the arrays must have
/// numbers up to there.
using TurnToAngles = void(const Real* angles, std::uint32_t count, Real* cosines, Real* sines);

}  // namespace impulse::inline IMPULSE_PRECISION
