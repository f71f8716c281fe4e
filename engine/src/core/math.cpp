#include "impulse/math.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/sin_cos.h"

namespace impulse::inline IMPULSE_PRECISION {

SinCos sin_cos(Real angle) {
  auto a = static_cast<double>(angle);
  if (!std::isfinite(a)) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    return {nan, nan};
  }
  // fmod is exact. Its divisor is not exactly 2 pi, but that changes the angle by less than half of its last bit.
  if (a > baseline::exact_range || a < -baseline::exact_range) a = std::fmod(a, 2 * 3.14159265358979323846);
  const auto turns = static_cast<std::int32_t>(baseline::quarter_turns(a));
  const auto reduced = baseline::reduce(a, static_cast<double>(turns));
  const double s = baseline::sine(reduced);
  const double c = baseline::cosine(reduced);
  switch (turns & 3) {
    case 0:
      return {static_cast<Real>(s), static_cast<Real>(c)};
    case 1:
      return {static_cast<Real>(c), static_cast<Real>(-s)};
    case 2:
      return {static_cast<Real>(-s), static_cast<Real>(-c)};
    default:
      return {static_cast<Real>(-c), static_cast<Real>(s)};
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
