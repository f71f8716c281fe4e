#pragma once

#include <cstdint>

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The most angles in one register.
constexpr std::uint32_t most_angles_at_once = 16;

/// Cosines and sines of `count` angles, with the bits of sin_cos. Whole registers are read and written: the arrays need
/// room up to a multiple of most_angles_at_once.
using TurnToAngles = void(const Real* angles, std::uint32_t count, Real* cosines, Real* sines);

}  // namespace impulse::inline IMPULSE_PRECISION
