#pragma once

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

/// 0.1_r: a literal of the engine's precision, rounded where it must be.
constexpr Real operator""_r(long double value) { return static_cast<Real>(value); }
constexpr Real operator""_r(unsigned long long value) { return static_cast<Real>(value); }

}  // namespace impulse::inline IMPULSE_PRECISION
