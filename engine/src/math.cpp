#include "impulse/math.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// pi/2 in three parts (Cody and Waite, "Software manual for the elementary functions", 1980). The first two have 33
// bits, so that their products with a count of quarter turns below 2^20 are exact.
constexpr double quarter_1 = 0x1.921fb544p+0;
constexpr double quarter_2 = 0x1.0b4611a6p-34;
constexpr double quarter_3 = 0x1.3198a2e037073p-69;

// Up to here the count of quarter turns stays below 2^20.
constexpr double exact_range = 1.6e6;

// An angle within pi/4 of zero, as a sum of which the second part is beyond the first's last bit.
struct Reduced {
  double head;
  double tail;
  std::int64_t quadrant;
};

Reduced reduce(double angle) {
  const double turns = angle * (2.0 / 3.14159265358979323846);
  const std::int64_t count = static_cast<std::int64_t>(turns < 0 ? turns - 0.5 : turns + 0.5);
  const auto n = static_cast<double>(count);
  const double first = angle - n * quarter_1;  // exact: near-equal numbers
  const double product = n * quarter_2;
  const double second = first - product;
  const double taken = first - second;  // two-sum: what rounding took from `second`
  const double lost = (first - (second + taken)) - (product - taken);
  const double rest = n * quarter_3 - lost;
  const double head = second - rest;
  return {head, (second - head) - rest, count};
}

// Taylor's series: the first term left out is below 1e-19 on [-pi/4, pi/4]. The tail enters to first order.
double sine(double x, double tail) {
  const double z = x * x;
  double series = 1 / 355687428096000.0;  // 1/17!
  series = series * z - 1 / 1307674368000.0;
  series = series * z + 1 / 6227020800.0;
  series = series * z - 1 / 39916800.0;
  series = series * z + 1 / 362880.0;
  series = series * z - 1 / 5040.0;
  series = series * z + 1 / 120.0;
  series = series * z - 1 / 6.0;
  return x + (x * z * series + tail * (1 - 0.5 * z));
}

double cosine(double x, double tail) {
  const double z = x * x;
  double series = -1 / 6402373705728000.0;  // 1/18!
  series = series * z + 1 / 20922789888000.0;
  series = series * z - 1 / 87178291200.0;
  series = series * z + 1 / 479001600.0;
  series = series * z - 1 / 3628800.0;
  series = series * z + 1 / 40320.0;
  series = series * z - 1 / 720.0;
  series = series * z + 1 / 24.0;
  const double half = 0.5 * z;
  const double main = 1 - half;
  return main + (((1 - main) - half) + (z * z * series - x * tail));
}

}  // namespace

SinCos sin_cos(Real angle) {
  auto a = static_cast<double>(angle);
  if (!std::isfinite(a)) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    return {nan, nan};
  }
  // The remainder is exact; that its divisor is not quite 2 pi moves the angle by less than half of its own last bit.
  if (a > exact_range || a < -exact_range) a = std::fmod(a, 2 * 3.14159265358979323846);
  const Reduced r = reduce(a);
  const double s = sine(r.head, r.tail);
  const double c = cosine(r.head, r.tail);
  switch (r.quadrant & 3) {
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
