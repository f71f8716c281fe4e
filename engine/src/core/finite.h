#pragma once

#include <cmath>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

inline bool finite(Real x) { return std::isfinite(x); }
inline bool finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace impulse::inline IMPULSE_PRECISION
