#include "kernels.h"

#include <array>

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const Kernels table;
}
namespace baseline {
extern const Kernels table;
}
namespace avx2 {
extern const Kernels table;
}

namespace {

#ifdef IMPULSE_AVX2

constexpr std::array versions{&scalar::table, &baseline::table, &avx2::table};

std::size_t runnable() { return __builtin_cpu_supports("avx2") != 0 ? 3 : 2; }

#else

constexpr std::array versions{&scalar::table, &baseline::table};

std::size_t runnable() { return 2; }

#endif

}  // namespace

std::span<const Kernels* const> runnable_kernels() {
  static const std::size_t count = runnable();
  return std::span(versions).first(count);
}

}  // namespace impulse::inline IMPULSE_PRECISION
