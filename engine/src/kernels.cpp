#include "kernels.h"

#include <array>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

#ifdef IMPULSE_AVX2

constexpr std::array versions{Kernels{baseline::find_overlaps}, Kernels{avx2::find_overlaps}};

std::size_t runnable() { return __builtin_cpu_supports("avx2") != 0 ? 2 : 1; }

#else

constexpr std::array versions{Kernels{baseline::find_overlaps}};

std::size_t runnable() { return 1; }

#endif

}  // namespace

std::span<const Kernels> runnable_kernels() {
  static const std::size_t count = runnable();
  return std::span(versions).first(count);
}

}  // namespace impulse::inline IMPULSE_PRECISION
