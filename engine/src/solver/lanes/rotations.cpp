#include <cstring>

#include "core/simd.h"
#include "core/sin_cos.h"
#include "impulse/math.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

// The number of doubles in a register; the other vectors have as many elements.
constexpr std::uint32_t register_bytes = Register::width * sizeof(Real);
constexpr std::uint32_t doubles_at_once = register_bytes > sizeof(double) ? register_bytes / sizeof(double) : 1;
typedef double Doubles __attribute__((vector_size(doubles_at_once * sizeof(double))));
typedef std::uint64_t Bits __attribute__((vector_size(doubles_at_once * sizeof(double))));
typedef std::int32_t Counts __attribute__((vector_size(doubles_at_once * sizeof(std::int32_t))));
typedef Real Reals __attribute__((vector_size(doubles_at_once * sizeof(Real))));

Doubles load(const Real* from) {
  Reals numbers;
  std::memcpy(&numbers, from, sizeof numbers);
  return __builtin_convertvector(numbers, Doubles);
}

void store(Bits bits, Real* to) {
  const Reals numbers = __builtin_convertvector(reinterpret_cast<Doubles>(bits), Reals);
  std::memcpy(to, &numbers, sizeof numbers);
}

bool any(Bits bits) {
  bool some = false;
  for (std::uint32_t i = 0; i < doubles_at_once; ++i) some |= bits[i] != 0;
  return some;
}

}  // namespace

void turn_to_angles(const Real* angles, std::uint32_t count, Real* cosines, Real* sines) {
  Bits far{};
  for (std::uint32_t i = 0; i < count; i += doubles_at_once) {
    Doubles angle = load(angles + i);
    const auto near = (angle <= exact_range) & (angle >= -exact_range);
    far |= reinterpret_cast<Bits>(~near);
    angle = near ? angle : Doubles{};
    const Counts turns = __builtin_convertvector(quarter_turns(angle), Counts);
    const Reduced<Doubles> reduced = reduce(angle, __builtin_convertvector(turns, Doubles));
    const auto sine_bits = reinterpret_cast<Bits>(sine(reduced));
    const auto cosine_bits = reinterpret_cast<Bits>(cosine(reduced));
    // An odd quadrant swaps the two; quadrants 2 and 3 flip the sign of the sine, 1 and 2 that of the cosine.
    const Bits quadrant = __builtin_convertvector(turns, Bits);
    const Bits odd = Bits{} - (quadrant & 1);
    const Bits exchange = odd & (sine_bits ^ cosine_bits);
    store(sine_bits ^ exchange ^ (quadrant & 2) << 62, sines + i);
    store(cosine_bits ^ exchange ^ ((quadrant + 1) & 2) << 62, cosines + i);
  }
  if (!any(far)) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto angle = static_cast<double>(angles[i]);
    if (angle <= exact_range && angle >= -exact_range) continue;
    const SinCos of = sin_cos(angles[i]);
    cosines[i] = of.cos;
    sines[i] = of.sin;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
