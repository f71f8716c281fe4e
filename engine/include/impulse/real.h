#pragma once

/// The one place where precision is chosen. The same source is compiled once for float and once for double; an inline
/// namespace keeps the two apart, so that one program may hold both. Users write impulse::World and link
/// impulse::impulse (float) or impulse::impulse_double (which defines IMPULSE_DOUBLE).
#ifdef IMPULSE_DOUBLE
#define IMPULSE_PRECISION double_precision
#else
#define IMPULSE_PRECISION single_precision
#endif

namespace impulse::inline IMPULSE_PRECISION {

#ifdef IMPULSE_DOUBLE
using Real = double;
#else
using Real = float;
#endif

constexpr Real pi = static_cast<Real>(3.14159265358979323846);

}  // namespace impulse::inline IMPULSE_PRECISION
