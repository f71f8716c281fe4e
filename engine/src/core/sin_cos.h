#pragma once

#include "core/simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

/// Sine and cosine from + - * alone, in double even if Real is float. N is a double or a vector of them: both take the
/// same steps, without branches.

// pi/2 in three parts (Cody and Waite, "Software manual for the elementary functions", 1980). The first two have 33
// bits, so their products with a number of quarter turns below 2^20 are exact.
constexpr double quarter_1 = 0x1.921fb544p+0;
constexpr double quarter_2 = 0x1.0b4611a6p-34;
constexpr double quarter_3 = 0x1.3198a2e037073p-69;

/// rad; up to this angle the number of quarter turns stays below 2^20.
constexpr double exact_range = 1.6e6;

/// An angle minus a whole number of quarter turns, within pi/4 of zero, as a sum: the tail extends the head below its
/// last bit.
template <class N>
struct Reduced {
  N head;
  N tail;
};

template <class N>
N quarter_turns(N angle) {
  const N turns = angle * (2.0 / 3.14159265358979323846);
  return turns < 0.0 ? turns - 0.5 : turns + 0.5;  // the caller truncates to a whole number
}

template <class N>
Reduced<N> reduce(N angle, N whole_turns) {
  const N first = angle - whole_turns * quarter_1;  // exact: the two are nearly equal
  const N product = whole_turns * quarter_2;
  const N second = first - product;
  const N taken = first - second;  // two-sum: recovers the rounding error of `second`
  const N lost = (first - (second + taken)) - (product - taken);
  const N rest = whole_turns * quarter_3 - lost;
  const N head = second - rest;
  return {head, (second - head) - rest};
}

// Taylor series: the first omitted term is below 1e-19 on [-pi/4, pi/4]. The tail enters to first order.
template <class N>
N sine(const Reduced<N>& angle) {
  const N x = angle.head;
  const N z = x * x;
  N series = z * (1 / 355687428096000.0) - 1 / 1307674368000.0;  // 1/17!, 1/15!
  series = series * z + 1 / 6227020800.0;
  series = series * z - 1 / 39916800.0;
  series = series * z + 1 / 362880.0;
  series = series * z - 1 / 5040.0;
  series = series * z + 1 / 120.0;
  series = series * z - 1 / 6.0;
  return x + (x * z * series + angle.tail * (1.0 - 0.5 * z));
}

template <class N>
N cosine(const Reduced<N>& angle) {
  const N x = angle.head;
  const N z = x * x;
  N series = z * (-1 / 6402373705728000.0) + 1 / 20922789888000.0;  // 1/18!, 1/16!
  series = series * z - 1 / 87178291200.0;
  series = series * z + 1 / 479001600.0;
  series = series * z - 1 / 3628800.0;
  series = series * z + 1 / 40320.0;
  series = series * z - 1 / 720.0;
  series = series * z + 1 / 24.0;
  const N half = 0.5 * z;
  const N main = 1.0 - half;
  return main + (((1.0 - main) - half) + (z * z * series - x * angle.tail));
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
