#include "kernels.h"

#include <array>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Kernels in_baseline() {
  using namespace baseline;
  return {find_overlaps, collide_boxes, collide_discs, collide_disc_with_box, collide_box_with_disc, measure_again};
}

#ifdef IMPULSE_AVX2

constexpr Kernels in_avx2() {
  using namespace avx2;
  return {find_overlaps, collide_boxes, collide_discs, collide_disc_with_box, collide_box_with_disc, measure_again};
}

constexpr std::array versions{in_baseline(), in_avx2()};

std::size_t runnable() { return __builtin_cpu_supports("avx2") != 0 ? 2 : 1; }

#else

constexpr std::array versions{in_baseline()};

std::size_t runnable() { return 1; }

#endif

}  // namespace

std::span<const Kernels> runnable_kernels() {
  static const std::size_t count = runnable();
  return std::span(versions).first(count);
}

}  // namespace impulse::inline IMPULSE_PRECISION
