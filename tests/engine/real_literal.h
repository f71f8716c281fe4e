#pragma once

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// 0.1_r is a literal of type Real, rounded if necessary.
constexpr Real operator""_r(long double value) { return static_cast<Real>(value); }
constexpr Real operator""_r(unsigned long long value) { return static_cast<Real>(value); }

}  // namespace impulse::inline IMPULSE_PRECISION
